//! `report.html`: a run to be looked at in a browser, in one file. It is made of what stands in the run's directory, at any time, by one
//! process; it takes nothing from elsewhere, and works without a network.
//!
//! The page and its script are in `page/`; three.js draws the particles, uPlot the curves.

mod checkpoint;
mod history;
mod page;
mod particles;

use std::path::{Path, PathBuf};

use base64::Engine;
use base64::engine::general_purpose::STANDARD as BASE64;
use serde_json::{Value as Json, json};

use crate::error::{Error, Result};
use crate::output::publish::replace_text;

/// The name of the file.
pub const NAME: &str = "report.html";
/// Seconds after which the report of a run that goes on is read again.
const REFRESH: u32 = 30;
/// Bytes of pictures at most.
const PICTURES: usize = 4 << 20;

/// Writes the report of the run, search or study in `directory`; `goes_on`: whether it is not over. Returns the file.
///
/// # Errors
/// Where there is no run, or the file cannot be written.
pub fn write(directory: &Path, goes_on: bool) -> Result<PathBuf> {
    let read = |name: &str| std::fs::read_to_string(directory.join(name)).ok();
    let scene = read("scene.toml");
    let summary: Json = read("summary.json").and_then(|text| serde_json::from_str(&text).ok()).unwrap_or(Json::Null);
    if scene.is_none() && summary.is_null() {
        let error = Error::new("there is no run: neither summary.json nor scene.toml is here");
        return Err(error.at(directory.display().to_string()).allowed("the directory of a run").bad_input());
    }
    let history = read("history.csv").map_or(Json::Null, |text| history::table(&text));
    // A view without its particles is better than no report.
    let cloud = particles::read(directory).unwrap_or_else(|what| {
        tracing::warn!("the report of {} has no particles: {what}", directory.display());
        None
    });
    let title = summary["title"].as_str().map(str::to_string).or_else(|| title(scene.as_deref()));
    let title = title.filter(|title| !title.is_empty()).unwrap_or_else(|| directory.display().to_string());
    let data = json!({
        "state": state(&summary, &history, goes_on),
        "summary": summary,
        "scene": scene,
        "history": history,
        "impacts": parts(directory),
        "particles": cloud.as_ref().map(|cloud| &cloud.about),
    });
    let snapshots = cloud.iter().flat_map(|cloud| &cloud.snapshots).enumerate();
    let snapshots: String = snapshots
        .map(|(k, bytes)| {
            format!("<script type=\"text/plain\" id=\"snapshot-{k}\">{}</script>\n", BASE64.encode(bytes))
        })
        .collect();
    let page = page::Page {
        title: &title,
        refresh: if goes_on { format!("<meta http-equiv=\"refresh\" content=\"{REFRESH}\">") } else { String::new() },
        pictures: pictures(directory),
        data: data.to_string(),
        snapshots,
    };
    let path = directory.join(NAME);
    replace_text(&path, &page.text())?;
    Ok(path)
}

fn title(scene: Option<&str>) -> Option<String> {
    let table: toml::Table = scene?.parse().ok()?;
    Some(table.get("title")?.as_str()?.to_string())
}

/// Where the run stands, in words.
fn state(summary: &Json, history: &Json, goes_on: bool) -> String {
    if goes_on {
        let last = |name: &str| {
            let k = history["names"].as_array()?.iter().position(|known| known == name)?;
            history["columns"][k].as_array()?.last()?.as_f64()
        };
        let at = last("time").map_or(String::new(), |time| format!(", at t = {time:.4e} s"));
        return format!("Running{at}. This page is read again every {REFRESH} s.");
    }
    if let (Some(impacts), Some(steps)) = (summary["threshold"]["impacts"].as_array(), summary["steps"].as_u64()) {
        return format!("{} impacts, {steps} steps.", impacts.len());
    }
    match (summary["steps"].as_u64(), summary["time"].as_f64()) {
        (Some(steps), Some(time)) => format!("{steps} steps, to t = {time:.4e} s."),
        _ => "It has not come to its end.".into(),
    }
}

/// Folders of the impacts of a search, in their order.
fn parts(directory: &Path) -> Vec<String> {
    let names = (1..).map(|number| format!("impact_{number:02}"));
    names.take_while(|name| directory.join(name).is_dir()).collect()
}

/// All pictures of the directory, as parts of the page.
fn pictures(directory: &Path) -> String {
    let files = std::fs::read_dir(directory).into_iter().flatten().flatten().map(|entry| entry.path());
    let mut files: Vec<PathBuf> = files.filter(|path| path.extension().is_some_and(|e| e == "png")).collect();
    files.sort();
    let mut left = PICTURES;
    let mut text = String::new();
    for path in files {
        let Ok(bytes) = std::fs::read(&path) else { continue };
        let name = path.file_name().unwrap_or_default().to_string_lossy().into_owned();
        if bytes.len() > left {
            tracing::warn!("{name} is not in the report, which would become too large");
            continue;
        }
        left -= bytes.len();
        let name = page::escaped(&name);
        let source = BASE64.encode(bytes);
        text += &format!(
            "<figure><img alt=\"{name}\" src=\"data:image/png;base64,{source}\"><figcaption>{name}</figcaption></figure>\n"
        );
    }
    text
}

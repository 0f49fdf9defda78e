//! The page: its template filled with what is known of a run.

const TEMPLATE: &str = include_str!("page/page.html");
const STYLE: [&str; 2] = [include_str!("page/libraries.css"), include_str!("page/page.css")];
const LIBRARIES: &str = include_str!("page/libraries.js");
const SCRIPT: &str = include_str!("page/page.js");

/// The parts of a page that differ between runs; all but the title as they stand in it.
pub struct Page<'a> {
    pub title: &'a str,
    pub refresh: String,
    pub pictures: String,
    pub data: String,
    pub snapshots: String,
}

impl Page<'_> {
    /// The whole file.
    pub fn text(&self) -> String {
        let parts = [
            ("title", escaped(self.title)),
            ("refresh", self.refresh.clone()),
            ("style", STYLE.concat()),
            ("pictures", self.pictures.clone()),
            ("version", env!("CARGO_PKG_VERSION").to_string()),
            // No `<` of a name or a number ends the script that it stands in.
            ("data", self.data.replace('<', "\\u003c")),
            ("snapshots", self.snapshots.clone()),
            ("libraries", LIBRARIES.to_string()),
            ("script", SCRIPT.to_string()),
        ];
        filled(TEMPLATE, &parts)
    }
}

/// Text as HTML shows it.
pub fn escaped(text: &str) -> String {
    text.replace('&', "&amp;").replace('<', "&lt;").replace('>', "&gt;").replace('"', "&quot;")
}

/// The template with every `{name}` replaced, once: what is filled in is not looked at.
fn filled(template: &str, parts: &[(&str, String)]) -> String {
    let mut text = String::new();
    for piece in template.split('{') {
        let part = piece.split_once('}').and_then(|(name, rest)| {
            let (_, value) = parts.iter().find(|(known, _)| *known == name)?;
            Some((value, rest))
        });
        match part {
            Some((value, rest)) => text.extend([value.as_str(), rest]),
            None => text.push_str(piece),
        }
    }
    text
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn names_cannot_break_the_page() {
        let page = Page {
            title: "<b>\"x\" & y</b> {data}",
            refresh: String::new(),
            pictures: String::new(),
            data: "{\"title\":\"</script><script>alert(1)</script>\"}".into(),
            snapshots: String::new(),
        };
        let text = page.text();
        assert!(text.contains("<h1>&lt;b&gt;&quot;x&quot; &amp; y&lt;/b&gt; {data}</h1>"));
        assert!(text.contains("\\u003c/script>\\u003cscript>alert(1)") && !text.contains("<script>alert(1)"));
        // One element of data, one of libraries, one of its own.
        assert_eq!(text.matches("</script>").count(), 3);
        assert!(!text.contains("http://") || !text.contains("src=\"http"), "it takes nothing from elsewhere");
    }
}

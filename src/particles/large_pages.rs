//! Large pages for large arrays: gathers over many megabytes miss fewer translations, and fresh memory comes with a five-hundredth
//! of the faults. Where the system does not offer them, nothing happens.

/// Bytes of a large page.
const LARGE: usize = 2 << 20;

/// Asks for large pages where the array's memory, spare capacity included, covers whole ones. What was written before keeps
/// the pages it has: to be called when an array has got its memory.
pub fn prefer_large_pages<T>(array: &Vec<T>) {
    let start = array.as_ptr() as usize;
    let end = (start + array.capacity() * size_of::<T>()) / LARGE * LARGE;
    let start = start.next_multiple_of(LARGE);
    if start < end {
        // SAFETY: whole pages within the array's own memory; the advice changes no content. An error means that there are no
        // large pages here.
        unsafe { libc::madvise(start as *mut libc::c_void, end - start, libc::MADV_HUGEPAGE) };
    }
}

/// An empty array with room for so many elements, in large pages.
pub fn with_capacity<T>(capacity: usize) -> Vec<T> {
    let array = Vec::with_capacity(capacity);
    prefer_large_pages(&array);
    array
}

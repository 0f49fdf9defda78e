//! Large pages for large arrays: gathers over many megabytes miss fewer translations, and fresh memory comes with a five-hundredth
//! of the faults. Where the system does not offer them, memory stays as it is.

/// Bytes of a page, and of a large one.
const PAGE: usize = 4 << 10;
const LARGE: usize = 2 << 20;

/// Requests large pages where the array's memory, spare capacity included, may hold some. Memory that was written before keeps its
/// pages: to be called when an array has been allocated.
pub fn prefer_large_pages<T>(array: &Vec<T>) {
    let bytes = array.capacity() * size_of::<T>();
    if bytes < 2 * LARGE {
        return;
    }
    // All pages that the array touches: a mapping of which only a part were advised would be cut in two, and could then only
    // grow by a copy.
    let start = array.as_ptr() as usize / PAGE * PAGE;
    let end = (array.as_ptr() as usize + bytes).next_multiple_of(PAGE);
    // SAFETY: these pages exist, as each holds a part of the array; the advice changes no content, of the array or beside it.
    // An error means that there are no large pages here.
    unsafe { libc::madvise(start as *mut libc::c_void, end - start, libc::MADV_HUGEPAGE) };
}

/// An empty array with room for so many elements, in large pages.
pub fn with_capacity<T>(capacity: usize) -> Vec<T> {
    let array = Vec::with_capacity(capacity);
    prefer_large_pages(&array);
    array
}

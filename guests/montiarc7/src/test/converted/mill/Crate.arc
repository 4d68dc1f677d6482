package mill;

/** Holds numbers only, one of which is compared with others. */
component Crate<T extends Number & Comparable<T>> {
    timing instant;
    port in T content, in Integer amount;
}

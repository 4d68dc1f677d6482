package mill;

component Ends<T> {
    timing instant;
    port in T input;
    port out T output;
}

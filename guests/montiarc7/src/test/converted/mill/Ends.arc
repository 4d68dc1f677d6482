package mill;

component Ends<T> {
    port in T input;
    port out T output;
}

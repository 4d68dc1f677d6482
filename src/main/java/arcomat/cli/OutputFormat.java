package arcomat.cli;

/** How results are written. */
enum OutputFormat {
    text,
    json
}

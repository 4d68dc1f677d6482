package arcomat.cli.option;

/** How results are written. */
public enum OutputFormat {
    text,
    json
}

package arcomat.generate;

/**
 * A file to be written.
 *
 * @param path relative, with forward slashes; never leaves the output folder
 */
public record GeneratedFile(String path, String text) {}

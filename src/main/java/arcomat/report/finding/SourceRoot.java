package arcomat.report.finding;

import java.nio.charset.StandardCharsets;

/**
 * The folder that reports for machines count from: whoever reads them elsewhere has the same files
 * below a folder of another name.
 *
 * @param directory absolute, with forward slashes
 */
public record SourceRoot(String directory) {
    private static final String UNRESERVED = "-._~/";

    /** A path as seen from here, where it lies below; others are as they are. */
    String relative(String path) {
        String folder = directory.endsWith("/") ? directory : directory + "/";
        return path.startsWith(folder) ? path.substring(folder.length()) : path;
    }

    /** Whether a path, as {@link #relative} has it, counts from here. */
    static boolean isRelative(String path) {
        return !path.startsWith("/") && !path.matches("[A-Za-z]:/.*");
    }

    /** A path as RFC 3986 writes it: a reference, or a whole URI where the path is absolute. */
    String uri(String path) {
        String shown = relative(path);
        String encoded = encode(shown);
        if (isRelative(shown)) {
            return encoded;
        }
        return shown.startsWith("/") ? "file://" + encoded : "file:///" + encoded;
    }

    private static String encode(String path) {
        StringBuilder out = new StringBuilder();
        for (byte octet : path.getBytes(StandardCharsets.UTF_8)) {
            char c = (char) (octet & 0xff);
            boolean plain =
                    c >= 'a' && c <= 'z'
                            || c >= 'A' && c <= 'Z'
                            || c >= '0' && c <= '9'
                            || UNRESERVED.indexOf(c) >= 0;
            out.append(plain ? String.valueOf(c) : String.format("%%%02X", (int) c));
        }
        return out.toString();
    }
}

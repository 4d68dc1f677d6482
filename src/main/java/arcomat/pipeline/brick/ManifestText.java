package arcomat.pipeline.brick;

import java.nio.charset.StandardCharsets;
import java.util.Optional;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The manifest of a jar, of which the JDK's reader tells on standard error what it dislikes. */
final class ManifestText {
    /** A line that begins with a blank goes on where the one before ended. */
    private static final Pattern FOLD = Pattern.compile("\\r?\\n ");

    private static final Pattern MAIN = Pattern.compile("(?im)^Main-Class: *(\\S+) *$");
    private static final Pattern SECTION_END = Pattern.compile("\\r?\\n\\r?\\n");

    private ManifestText() {}

    /** The class that the program begins in, as the first section of the manifest names it. */
    static Optional<String> mainClass(byte[] manifest) {
        String text = new String(manifest, StandardCharsets.UTF_8);
        String first = SECTION_END.split(text, 2)[0];
        Matcher main = MAIN.matcher(FOLD.matcher(first).replaceAll(""));
        return main.find() ? Optional.of(main.group(1)) : Optional.empty();
    }
}

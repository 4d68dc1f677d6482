package arcomat.diagram;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.regex.Matcher;
import java.util.regex.Pattern;

/** The looks of pictures: one style sheet, shared by all that shows them. */
public enum Theme {
    /** As the reader has it: light or dark. */
    ADAPTIVE,
    /** Light, without variables and nested selectors: for programs that know little of CSS. */
    LIGHT;

    private static final Pattern VARIABLE = Pattern.compile("(--[a-z-]+): ([^;]+);");

    /** The style sheet {@code picture.css}. */
    public String css() {
        String sheet = read("/diagram/picture.css");
        if (this == ADAPTIVE) {
            return sheet;
        }
        int rules = sheet.indexOf("/* Rules");
        int dark = sheet.indexOf("@media");
        String css = sheet.substring(rules).replace(".arcomat ", "");
        Matcher variable = VARIABLE.matcher(sheet.substring(0, dark));
        while (variable.find()) {
            css = css.replace("var(" + variable.group(1) + ")", variable.group(2));
        }
        return css;
    }

    private static String read(String resource) {
        try (InputStream in = Theme.class.getResourceAsStream(resource)) {
            return new String(in.readAllBytes(), StandardCharsets.UTF_8);
        } catch (IOException e) {
            throw new UncheckedIOException(e);
        }
    }
}

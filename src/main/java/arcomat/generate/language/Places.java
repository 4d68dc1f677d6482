package arcomat.generate.language;

import arcomat.model.Component;
import arcomat.source.Span;

/** Where something is written in the models, for comments. */
public final class Places {
    private static final int LONGEST = 120;

    private Places() {}

    public static int line(Span span) {
        return span == null ? 0 : span.startPosition().line();
    }

    /** The file of a component under its model root, wherever that is: output must not differ. */
    public static String file(Component component) {
        if (component.span() == null) {
            return "";
        }
        String path = component.span().file().path();
        String folder = component.packageName().replace('.', '/');
        String name = path.substring(path.lastIndexOf('/') + 1);
        return Escapes.comment(folder.isEmpty() ? name : folder + "/" + name);
    }

    /** {@code line 12: driving -> waiting {frontUS == tooClose}}. */
    public static String quote(Span span) {
        return span == null || span.text().isEmpty()
                ? ""
                : "line " + line(span) + ": " + text(span);
    }

    /** The text of a declaration on one line, cut where it is long. */
    public static String text(Span span) {
        String text = Escapes.comment(span.text());
        return text.length() <= LONGEST ? text : text.substring(0, LONGEST).stripTrailing() + " ..";
    }
}

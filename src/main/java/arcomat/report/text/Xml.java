package arcomat.report.text;

import java.util.Map;

/**
 * XML 1.0 text, well-formed whatever names and messages contain: characters that XML has no way to
 * write become escapes as Java writes them.
 */
public final class Xml {
    private static final String INDENT = "  ";

    private final StringBuilder out =
            new StringBuilder("<?xml version=\"1.0\" encoding=\"UTF-8\"?>\n");
    private int depth;

    /** Opens an element. Attributes are written in the order of the map. */
    public Xml open(String element, Map<String, String> attributes) {
        start(element, attributes).append(">\n");
        depth++;
        return this;
    }

    public Xml close(String element) {
        depth--;
        indent().append("</").append(element).append(">\n");
        return this;
    }

    /** An element without content. */
    public Xml empty(String element, Map<String, String> attributes) {
        start(element, attributes).append("/>\n");
        return this;
    }

    /** An element with text alone, which keeps its line breaks. */
    public Xml text(String element, Map<String, String> attributes, String text) {
        start(element, attributes)
                .append('>')
                .append(escape(Printable.escapeKeepingLayout(text)))
                .append("</")
                .append(element)
                .append(">\n");
        return this;
    }

    public String text() {
        return out.toString();
    }

    private StringBuilder start(String element, Map<String, String> attributes) {
        indent().append('<').append(element);
        attributes.forEach(
                (name, value) ->
                        out.append(' ')
                                .append(name)
                                .append("=\"")
                                .append(escape(Printable.escape(value)))
                                .append('"'));
        return out;
    }

    private StringBuilder indent() {
        return out.append(INDENT.repeat(depth));
    }

    private static String escape(String text) {
        return text.replace("&", "&amp;")
                .replace("<", "&lt;")
                .replace(">", "&gt;")
                .replace("\"", "&quot;");
    }
}

package arcomat.site;

import java.util.regex.Pattern;

/**
 * What a terminal shows: commands stand out, verdicts have their colours, codes lead to the pages
 * about them.
 *
 * @param address of the page it stands on
 */
record Transcript(String address) {
    private static final String PROMPT = "$ ";
    private static final Pattern CODE = Pattern.compile("\\b(ARC\\d{4})\\b");
    private static final Pattern GOOD = Pattern.compile("^( *)(holds|passed)\\b");
    private static final Pattern BAD = Pattern.compile("^( *)(fails|FAILED)\\b");
    private static final Pattern ERROR = Pattern.compile("(: )(error)(?= ARC)");
    private static final Pattern WARNING = Pattern.compile("(: )(warning)(?= ARC)");

    String html(String text) {
        StringBuilder html = new StringBuilder();
        text.lines().forEach(line -> html.append(line(line)).append('\n'));
        return html.toString();
    }

    private String line(String line) {
        if (line.startsWith(PROMPT)) {
            return "<span class=\"prompt\">$ </span><kbd>"
                    + Colours.escaped(line.substring(PROMPT.length()))
                    + "</kbd>";
        }
        String shown = Colours.escaped(line);
        shown = marked(shown, GOOD, "good");
        shown = marked(shown, BAD, "bad");
        shown = marked(shown, ERROR, "bad");
        shown = marked(shown, WARNING, "open");
        String page = Addresses.between(address, Addresses.ofFinding("CODE"));
        return CODE.matcher(shown)
                .replaceAll(
                        code ->
                                "<a href=\"%s\">%s</a>"
                                        .formatted(
                                                page.replace("CODE", code.group()), code.group()));
    }

    private static String marked(String line, Pattern words, String kind) {
        return words.matcher(line).replaceAll("$1<b class=\"" + kind + "\">$2</b>");
    }
}

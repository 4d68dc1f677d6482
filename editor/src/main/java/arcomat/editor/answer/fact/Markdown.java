package arcomat.editor.answer.fact;

/** Texts in the markup that editors show; what a model says cannot become markup of its own. */
final class Markdown {
    private static final String MARKUP = "\\`*_{}[]<>()#+-.!|~&";

    private Markdown() {}

    /** A line of the language. */
    static String code(String line) {
        return "```arcomat\n" + line.replaceAll("\\s+", " ").replace("```", "` ` `") + "\n```";
    }

    /** A name, or another word, within a text. */
    static String word(String word) {
        return "`" + word.replace('`', '\'').replaceAll("\\s+", " ") + "`";
    }

    /** Prose; its line breaks are kept. */
    static String text(String text) {
        StringBuilder written = new StringBuilder();
        for (char letter : text.toCharArray()) {
            if (MARKUP.indexOf(letter) >= 0) {
                written.append('\\');
            }
            written.append(letter == '\n' ? "  \n" : letter);
        }
        return written.toString();
    }
}

package arcomat.generate.language;

/**
 * A piece of target text with how tightly it binds.
 *
 * @param level the higher, the tighter; a place that asks for more gets parentheses
 */
public record Text(String text, int level) {
    /** Binds tighter than any operator: names, literals, calls. */
    public static final int PRIMARY = 100;

    public static Text primary(String text) {
        return new Text(text, PRIMARY);
    }

    /** Itself, or in parentheses where it binds less tightly than asked. */
    String atLevel(int wanted) {
        return level >= wanted ? text : "(" + text + ")";
    }

    @Override
    public String toString() {
        return text;
    }
}

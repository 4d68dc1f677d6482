package arcomat.symbols.expressions;

/** Pieces of messages. */
final class Texts {
    private static final int LONGEST = 40;

    private Texts() {}

    /** A piece of source that fits into a sentence. */
    static String shortened(String source) {
        String line = source.strip().replaceAll("\\s+", " ");
        return line.length() <= LONGEST ? line : line.substring(0, LONGEST - 2) + "..";
    }

    static String count(int number, String noun) {
        return number + " " + noun + (number == 1 ? "" : "s");
    }
}

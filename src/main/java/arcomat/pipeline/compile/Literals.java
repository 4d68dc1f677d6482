package arcomat.pipeline.compile;

/** String literals of generated Java; adjacent ones are one constant to a compiler. */
final class Literals {
    private static final String PLUS = " + \"";

    private final String code;
    private int at;

    private Literals(String code) {
        this.code = code;
    }

    /** The most bytes that a constant text takes in a class file. */
    static int longest(String code) {
        Literals literals = new Literals(code);
        int longest = 0;
        while (literals.at < code.length()) {
            longest = Math.max(longest, literals.next());
        }
        return longest;
    }

    /** The size of the next constant, behind which the place is afterwards. */
    private int next() {
        int size = 0;
        while (at < code.length() && code.charAt(at) != '"') {
            at = behind();
        }
        at++;
        while (at < code.length()) {
            char c = code.charAt(at);
            if (c == '"' && code.startsWith(PLUS, at + 1)) {
                at += 1 + PLUS.length();
            } else if (c == '"') {
                at++;
                return size;
            } else {
                size += c == '\\' ? escaped() : 1;
                at++;
            }
        }
        return 0;
    }

    /** Quotes in comments open nothing, and neither does {@code '"'}. */
    private int behind() {
        if (code.startsWith("//", at)) {
            return behind("\n");
        }
        if (code.startsWith("/*", at)) {
            return behind("*/");
        }
        return code.startsWith("'\"'", at) ? at + 3 : at + 1;
    }

    private int behind(String end) {
        int found = code.indexOf(end, at);
        return found < 0 ? code.length() : found + end.length();
    }

    /** The size of what is escaped, at whose last letter the place is afterwards. */
    private int escaped() {
        at++;
        if (code.charAt(at) == 'u') {
            int letter = Integer.parseInt(code.substring(at + 1, at + 5), 16);
            at += 4;
            return letter < 0x800 ? 2 : 3;
        }
        if (Character.isDigit(code.charAt(at))) {
            at += 2;
            return 2;
        }
        return 1;
    }
}

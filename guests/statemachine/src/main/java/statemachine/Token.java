package statemachine;

/**
 * A word, a sign or a literal.
 *
 * @param start offset in the text that is read; where there is no more, its end
 */
record Token(Kind kind, String text, int start) {
    enum Kind {
        WORD,
        SIGN,
        LITERAL,
        END
    }

    int end() {
        return start + text.length();
    }

    boolean is(String wanted) {
        return (kind == Kind.WORD || kind == Kind.SIGN) && text.equals(wanted);
    }

    boolean isWord() {
        return kind == Kind.WORD;
    }
}

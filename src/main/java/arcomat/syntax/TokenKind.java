package arcomat.syntax;

import arcomat.syntax.antlr.ArcomatLexer;

/** What a token does to the structure of a text, looked up by its type. */
enum TokenKind {
    OPENING,
    CLOSING,
    SEPARATOR,
    OPERATOR,
    /** {@code &&} and {@code ||}: however many in a row, they are no nesting. */
    CHAIN,
    /** Operators that bind less than those, and nest them. */
    LOOSE,
    OTHER;

    private static final TokenKind[] BY_TYPE = byType();

    private static TokenKind[] byType() {
        TokenKind[] kinds = new TokenKind[ArcomatLexer.VOCABULARY.getMaxTokenType() + 1];
        for (int type = 0; type < kinds.length; type++) {
            String literal = ArcomatLexer.VOCABULARY.getLiteralName(type);
            kinds[type] = literal == null ? OTHER : ofLiteral(literal);
        }
        return kinds;
    }

    /** Anything that may add a level to a parse tree counts as an operator. */
    private static TokenKind ofLiteral(String literal) {
        return switch (literal) {
            case "'('", "'['", "'{'" -> OPENING;
            case "')'", "']'", "'}'" -> CLOSING;
            case "','", "';'", "'|'" -> SEPARATOR;
            case "'.'", "'!'", "'~'", "'+'", "'-'", "'*'", "'/'", "'%'" -> OPERATOR;
            case "'<'", "'<='", "'>'", "'>='", "'=='", "'!='" -> OPERATOR;
            case "'isin'", "'instanceof'" -> OPERATOR;
            case "'&&'", "'||'" -> CHAIN;
            case "'<=>'", "'implies'", "'?'", "':'", "'if'", "'then'", "'else'" -> LOOSE;
            case "'forall'", "'exists'", "'let'" -> LOOSE;
            default -> OTHER;
        };
    }

    boolean isOperator() {
        return this == OPERATOR || this == CHAIN || this == LOOSE;
    }

    /** The kind of a token type; the end of the file is {@link #OTHER}. */
    static TokenKind of(int type) {
        return type < 0 ? OTHER : BY_TYPE[type];
    }
}

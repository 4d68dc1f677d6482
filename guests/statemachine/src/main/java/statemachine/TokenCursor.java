package statemachine;

import arcomat.guest.BehaviourLanguage.Written;
import arcomat.source.Span;

import statemachine.Machine.Label;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;

/** Walks through the tokens of a text. */
final class TokenCursor {
    private final Written text;
    private final List<Token> tokens;
    private int position;

    TokenCursor(Written text) {
        this.text = text;
        this.tokens = Tokens.of(text.body().text());
    }

    Token peek() {
        return tokens.get(position);
    }

    /** Stays at the end. */
    Token next() {
        Token next = peek();
        position = Math.min(position + 1, tokens.size() - 1);
        return next;
    }

    boolean isAt(String wanted) {
        return peek().is(wanted);
    }

    boolean isAtEnd() {
        return peek().kind() == Token.Kind.END;
    }

    void expect(String wanted) throws UnreadableText {
        if (!isAt(wanted)) {
            throw unexpected("'" + wanted + "'");
        }
        next();
    }

    Label name(String what) throws UnreadableText {
        if (!peek().isWord()) {
            throw unexpected(what);
        }
        Token word = next();
        return new Label(place(word), word.text());
    }

    UnreadableText unexpected(String wanted) {
        Token found = peek();
        String instead = isAtEnd() ? "the end" : "'" + found.text() + "'";
        Span place = isAtEnd() ? text.keyword() : place(found);
        return new UnreadableText(place, "here is %s; expected is %s".formatted(instead, wanted));
    }

    Span place(Token token) {
        return text.part(token.start(), token.end());
    }

    /** From a token to the one that was read last. */
    Span since(Token first) {
        return text.part(first.start(), tokens.get(position - 1).end());
    }

    /** What begins here with a bracket, up to the one that closes it; nothing where none begins. */
    Optional<Span> balanced(String open, String close) throws UnreadableText {
        if (!isAt(open)) {
            return Optional.empty();
        }
        Token first = next();
        for (int depth = 1; depth > 0; ) {
            if (isAtEnd()) {
                throw new UnreadableText(place(first), "'%s' is not closed".formatted(open));
            }
            Token next = next();
            depth += next.is(open) ? 1 : next.is(close) ? -1 : 0;
        }
        return Optional.of(since(first));
    }

    /** The tokens up to one of the signs, brackets within being balanced; it is not read. */
    List<Token> upTo(List<String> ends) throws UnreadableText {
        List<Token> found = new ArrayList<>();
        int depth = 0;
        while (depth > 0 || ends.stream().noneMatch(this::isAt)) {
            if (isAtEnd()) {
                throw unexpected("'" + ends.get(0) + "'");
            }
            Token next = next();
            if (List.of("(", "[", "{").contains(next.text())) {
                depth++;
            } else if (List.of(")", "]", "}").contains(next.text())) {
                depth--;
            }
            found.add(next);
        }
        return found;
    }
}

package arcomat.syntax;

import arcomat.source.ComposedForm;
import arcomat.source.Diagnostic;
import arcomat.source.RestOfFile;
import arcomat.source.Signs;
import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.syntax.antlr.ArcomatLexer;

import org.antlr.v4.runtime.Token;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;

/**
 * What can be said of a text before it is parsed. With a finding here it is not parsed at all.
 *
 * @param depth a bound for the nesting
 */
record TokenChecks(List<Diagnostic> findings, int depth) {

    /**
     * @param tokens all tokens of the file, the end of the file included
     * @param limit so many levels are not too deep
     */
    static TokenChecks of(SourceFile file, List<Token> tokens, int limit) {
        NestingGuard guard = new NestingGuard(limit);
        List<Diagnostic> findings = check(file, tokens, guard);
        return new TokenChecks(findings, guard.deepest());
    }

    private static List<Diagnostic> check(SourceFile file, List<Token> tokens, NestingGuard guard) {
        List<Diagnostic> findings = new ArrayList<>(0);
        boolean empty = true;
        boolean invariants = false;
        boolean marks = ComposedForm.firstMark(file.text()) >= 0;
        for (Token token : tokens) {
            if (token.getChannel() != Token.DEFAULT_CHANNEL || token.getType() == Token.EOF) {
                continue;
            }
            empty = false;
            invariants |= InvariantEnd.begins(token);
            if (guard.isTooDeep(token)) {
                findings.add(tooDeep(file, token, guard.limit()));
                break;
            }
            if (token.getType() == ArcomatLexer.UNCLOSED_STRING) {
                findings.add(unclosedString(file, token));
            } else if (token.getType() == ArcomatLexer.UNCLOSED_COMMENT) {
                findings.add(unclosedComment(file, token));
            } else if (token.getType() == ArcomatLexer.UNKNOWN
                    && Signs.changesDirection(token.getText().codePointAt(0))) {
                findings.add(UnknownCharacter.finding(span(file, token)));
            } else if (marks && token.getType() == ArcomatLexer.ID) {
                findings.addAll(strayMark(file, token));
            }
        }
        if (empty) {
            findings.add(Language.of(file).nothingDefined(file, 0));
        } else if (invariants && findings.isEmpty()) {
            findings.addAll(InvariantEnd.missing(file, tokens));
        }
        if (!empty && !findings.isEmpty()) {
            findings.add(RestOfFile.unread(findings.get(findings.size() - 1).span()));
        }
        return findings;
    }

    private static Diagnostic tooDeep(SourceFile file, Token token, int limit) {
        return Diagnostic.error(
                Codes.NESTING,
                file.span(token.getStartIndex(), token.getStopIndex() + 1),
                String.format(
                        Locale.ROOT,
                        "This is nested more than %,d levels deep. Split it: name the parts of a"
                                + " long expression by variables, or a component's parts by"
                                + " components of their own.",
                        limit));
    }

    /** An accent that is no part of a letter. */
    private static List<Diagnostic> strayMark(SourceFile file, Token name) {
        String normal = ComposedForm.of(name.getText());
        int stray = ComposedForm.firstMark(normal);
        if (stray < 0) {
            return List.of();
        }
        int start = name.getStartIndex() + name.getText().indexOf(normal.charAt(stray));
        return List.of(UnknownCharacter.finding(file.span(start, start + 1)));
    }

    private static Span span(SourceFile file, Token token) {
        return file.span(token.getStartIndex(), token.getStopIndex() + 1);
    }

    private static Diagnostic unclosedString(SourceFile file, Token token) {
        return Diagnostic.error(
                Codes.SYNTAX,
                file.span(token.getStartIndex(), token.getStopIndex() + 1),
                "This string is not closed. Put '\"' behind its last character, on the same line.");
    }

    /** The token reaches to the end of the file; its beginning is the place to mend. */
    private static Diagnostic unclosedComment(SourceFile file, Token token) {
        return Diagnostic.error(
                Codes.SYNTAX,
                file.span(token.getStartIndex(), token.getStartIndex() + 2),
                "This comment is not closed. Put '*/' at its end.");
    }
}

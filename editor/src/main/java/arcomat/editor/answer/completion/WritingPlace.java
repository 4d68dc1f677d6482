package arcomat.editor.answer.completion;

import arcomat.editor.desk.View;
import arcomat.pipeline.recheck.OpenModels;
import arcomat.source.SourceFile;
import arcomat.source.Span;
import arcomat.symbols.Workspace;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.TestSuiteSymbol;
import arcomat.syntax.Caret;
import arcomat.tree.Node;
import arcomat.tree.Unit;

import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * What is around a place where somebody is writing. The statement that is being written is taken
 * out, since it hardly ever parses before it is finished, and what it says is no reason for what it
 * could say.
 *
 * @param caret the place
 * @param offset where it is
 * @param unit the file without the statement; nothing where the rest does not parse either
 * @param workspace with that unit
 */
public record WritingPlace(Caret caret, int offset, Optional<Unit> unit, Workspace workspace) {

    public static WritingPlace of(View view, Caret caret) {
        return of(view.file(), caret, view.models()::draft);
    }

    /**
     * @param file as it is on the screen
     * @param drafts what names would mean if the file had another text
     */
    public static WritingPlace of(
            SourceFile file, Caret caret, Function<SourceFile, OpenModels.Draft> drafts) {
        SourceFile rest = new SourceFile(file.path(), without(caret.written(), file.text()));
        OpenModels.Draft draft = drafts.apply(rest);
        return new WritingPlace(caret, caret.written().end(), draft.unit(), draft.workspace());
    }

    /** Blanks keep all other places where they are. A statement is hoped to end with its line. */
    private static String without(Span statement, String text) {
        int end = statement.end();
        while (end < text.length() && "\n{}".indexOf(text.charAt(end)) < 0) {
            if (text.charAt(end++) == ';') {
                break;
            }
        }
        String blanks = text.substring(statement.start(), end).replaceAll("[^\\r\\n]", " ");
        return text.substring(0, statement.start()) + blanks + text.substring(end);
    }

    /** The innermost component around the place. */
    public Optional<ComponentSymbol> component() {
        return innermost(
                workspace.components().stream(), ComponentSymbol::unit, ComponentSymbol::node);
    }

    Optional<AutomatonSymbol> automaton() {
        Stream<AutomatonSymbol> all =
                Stream.concat(
                        workspace.bareAutomata().stream(),
                        component().stream().flatMap(each -> each.ownAutomata().stream()));
        return innermost(all, AutomatonSymbol::unit, AutomatonSymbol::node);
    }

    Optional<TestSuiteSymbol> testSuite() {
        return innermost(
                workspace.testSuites().stream(), TestSuiteSymbol::unit, TestSuiteSymbol::node);
    }

    private <S> Optional<S> innermost(
            Stream<S> all, Function<S, Unit> unitOf, Function<S, ? extends Node> node) {
        return unit.flatMap(
                here ->
                        all.filter(each -> unitOf.apply(each) == here)
                                .filter(each -> contains(node.apply(each).span()))
                                .min(Comparator.comparing(each -> length(node.apply(each)))));
    }

    private boolean contains(Span span) {
        return span.start() < offset && offset <= span.end();
    }

    private static int length(Node node) {
        return node.span().end() - node.span().start();
    }

    /** The word so many words before the place; empty where there are not so many. */
    String word(int back) {
        List<String> words = caret.statement();
        return back <= words.size() ? words.get(words.size() - back) : "";
    }

    /**
     * The name that ends so many words before the place; a number that is not written out is that
     * of any element.
     */
    String name(int back) {
        if (!word(back).equals("]")) {
            return word(back);
        }
        int open = back + 1;
        while (!word(open).isEmpty() && !word(open).equals("[")) {
            open++;
        }
        String number = open == back + 2 ? word(back + 1) : "";
        boolean isWritten = number.chars().allMatch(Character::isDigit) && !number.isEmpty();
        return "%s[%s]".formatted(word(open + 1), isWritten ? number : "0");
    }

    /** Whether a word stands in the statement that is being written. */
    boolean says(String word) {
        return caret.statement().contains(word);
    }
}

package arcomat.syntax.build;

import arcomat.source.Span;
import arcomat.syntax.antlr.ArcomatParser;
import arcomat.tree.Automaton;
import arcomat.tree.AutomatonElement;
import arcomat.tree.Behaviour;
import arcomat.tree.Element;
import arcomat.tree.Name;
import arcomat.tree.Statement;
import arcomat.tree.Stereotype;

import org.antlr.v4.runtime.ParserRuleContext;
import org.antlr.v4.runtime.Token;

import java.util.List;
import java.util.Optional;

/**
 * What is done in each slice, and what is done before the first one: an automaton with one state.
 * In the models of 2017 there is Java.
 */
final class Computations {
    /** Another word than the one that stands there, so that nobody takes that for a name. */
    private static final String STATE = "computing";

    private final Phrases phrases;
    private final StatementBuilder statements;
    private final List<Token> tokens;

    /**
     * @param tokens all those of the file
     */
    Computations(Phrases phrases, StatementBuilder statements, List<Token> tokens) {
        this.phrases = phrases;
        this.statements = statements;
        this.tokens = tokens;
    }

    Element element(ArcomatParser.ComputationContext context) {
        String keyword = context.keyword.getText();
        Optional<Name> name = phrases.optionalName(context.name());
        if (context.statements() == null) {
            ArcomatParser.JavaBlockContext block = context.javaBlock();
            return java(
                    context,
                    keyword,
                    name,
                    block,
                    NoStatement.in(block, tokens).map(token -> phrases.span(token, token)));
        }
        Statement.Sequence sequence = statements.sequence(context.statements());
        Optional<Span> java = sequence.match(new JavaWords());
        if (java.isPresent()) {
            return java(context, keyword, name, context.statements(), java);
        }
        if (keyword.equals("init")) {
            return new Element.Start(phrases.span(context.start, context.stop), name, sequence);
        }
        Span word = phrases.span(context.keyword, context.keyword);
        return new Behaviour.Computation(
                phrases.span(context.start, context.stop),
                automaton(
                        phrases.span(context.keyword, context.stop),
                        phrases.stereotypes(context.stereotypes()),
                        name,
                        new Name(word, STATE),
                        sequence));
    }

    private Element java(
            ArcomatParser.ComputationContext context,
            String keyword,
            Optional<Name> name,
            ParserRuleContext body,
            Optional<Span> first) {
        return new Element.JavaPart(
                phrases.span(context.start, context.stop),
                keyword,
                name,
                phrases.text(body),
                first.map(span -> new Name(span, span.text().replaceAll("\\s+", ""))));
    }

    private static Automaton automaton(
            Span span,
            List<Stereotype> stereotypes,
            Optional<Name> name,
            Name state,
            Statement.Sequence statements) {
        AutomatonElement.State declared =
                new AutomatonElement.State(state.span(), List.of(), state, List.of());
        return new Automaton(
                span,
                stereotypes,
                name,
                List.of(
                        new AutomatonElement.States(state.span(), List.of(declared)),
                        new AutomatonElement.Initial(
                                state.span(), List.of(state), Optional.empty()),
                        new AutomatonElement.Transition(
                                span,
                                state,
                                Optional.empty(),
                                Optional.empty(),
                                Optional.empty(),
                                Optional.empty(),
                                Optional.of(statements),
                                0,
                                0)));
    }

    /**
     * The elements of a component, each computation with the start that stands beside it. Where one
     * of them is Java, nobody knows what the others begin with or go on to: they are read as Java,
     * too.
     */
    static List<Element> begun(List<Element> elements) {
        if (elements.stream().anyMatch(Element.JavaPart.class::isInstance)) {
            return elements.stream().map(Computations::asJava).toList();
        }
        Optional<Element.Start> start =
                elements.stream()
                        .filter(Element.Start.class::isInstance)
                        .map(Element.Start.class::cast)
                        .findFirst();
        return start.isEmpty()
                ? elements
                : elements.stream().map(each -> begun(each, start.get())).toList();
    }

    private static Element begun(Element element, Element.Start start) {
        if (!(element instanceof Behaviour.Computation computation)) {
            return element;
        }
        Automaton automaton = computation.automaton();
        return new Behaviour.Computation(
                computation.span(),
                new Automaton(
                        automaton.span(),
                        automaton.stereotypes(),
                        automaton.name(),
                        automaton.elements().stream().map(each -> begun(each, start)).toList()));
    }

    private static AutomatonElement begun(AutomatonElement element, Element.Start start) {
        return element instanceof AutomatonElement.Initial initial
                ? new AutomatonElement.Initial(
                        start.span(),
                        initial.states(),
                        List.of(),
                        Optional.empty(),
                        Optional.of(start.statements()))
                : element;
    }

    private static Element asJava(Element element) {
        if (element instanceof Element.Start start) {
            return new Element.JavaPart(
                    start.span(),
                    "init",
                    start.name(),
                    start.statements().span().text(),
                    Optional.empty());
        }
        if (element instanceof Behaviour.Computation computation) {
            Automaton automaton = computation.automaton();
            Statement.Sequence statements =
                    automaton.elements(AutomatonElement.Transition.class).get(0).actions().get();
            return new Element.JavaPart(
                    computation.span(),
                    "compute",
                    automaton.name(),
                    statements.span().text(),
                    Optional.empty());
        }
        return element;
    }
}

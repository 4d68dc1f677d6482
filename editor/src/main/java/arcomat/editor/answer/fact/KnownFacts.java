package arcomat.editor.answer.fact;

import arcomat.editor.answer.flow.PortConnections;
import arcomat.pipeline.recheck.ReadModels;
import arcomat.source.Span;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.AutomatonSymbol.InitialSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.bodies.TransitionSymbol;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.occurrences.Referent;
import arcomat.symbols.occurrences.ReferentCases;
import arcomat.symbols.signatures.Signature;
import arcomat.tree.Expression;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;

/**
 * What is known of something beside its declaration, a line of markup each.
 *
 * @param models it is one of
 * @param place where it is named
 */
record KnownFacts(ReadModels models, Span place) implements ReferentCases<List<String>> {

    @Override
    public List<String> packageName(Referent.PackageName name) {
        return List.of();
    }

    @Override
    public List<String> component(Referent.Component component) {
        Signature signature = component.signature();
        List<String> facts = new ArrayList<>();
        facts.add("component " + Markdown.word(signature.qualifiedName()));
        signature.refines().stream()
                .flatMap(each -> each.resolution().found().stream())
                .forEach(each -> facts.add("refines " + Markdown.word(each.qualifiedName())));
        models.workspace().components().stream()
                .filter(each -> each.signature().equals(signature))
                .flatMap(this::inside)
                .forEach(facts::add);
        return facts;
    }

    private Stream<String> inside(ComponentSymbol component) {
        List<String> facts = new ArrayList<>();
        if (component.isDecomposed()) {
            facts.add(
                    "made of %s and %s"
                            .formatted(
                                    number(component.instances().size(), "part"),
                                    number(component.connectors().size(), "connection")));
        }
        component.automata().forEach(each -> facts.add(size(each)));
        List<String> wholes =
                new PortConnections(models)
                        .parts(component).stream()
                                .map(part -> Markdown.word(part.owner().qualifiedName()))
                                .distinct()
                                .toList();
        if (!wholes.isEmpty()) {
            facts.add("a part of " + Enumeration.of(wholes));
        }
        return facts.stream();
    }

    private static String size(AutomatonSymbol automaton) {
        return "an automaton with %s and %s"
                .formatted(
                        number(automaton.states().size(), "state"),
                        number(automaton.transitions().size(), "transition"));
    }

    private static String number(int count, String noun) {
        return count + " " + noun + (count == 1 ? "" : "s");
    }

    @Override
    public List<String> diagram(Referent.Diagram diagram) {
        return List.of("class diagram " + Markdown.word(diagram.qualifiedName()));
    }

    @Override
    public List<String> type(Referent.Type type) {
        return List.of("type " + Markdown.word(type.symbol().qualifiedName()));
    }

    @Override
    public List<String> builtin(Referent.Builtin type) {
        return List.of("a type that is built in");
    }

    @Override
    public List<String> typeParameter(Referent.TypeParameter parameter) {
        return List.of("a type parameter");
    }

    @Override
    public List<String> constant(Referent.Constant constant) {
        return List.of(
                "constant number %d of %s"
                        .formatted(
                                constant.ordinal() + 1,
                                Markdown.word(constant.type().qualifiedName())));
    }

    @Override
    public List<String> attribute(Referent.Attribute attribute) {
        return List.of("attribute of " + Markdown.word(attribute.symbol().owner().qualifiedName()));
    }

    @Override
    public List<String> port(Referent.Port port) {
        return new PortFacts(models, port.symbol(), place).all();
    }

    @Override
    public List<String> part(Referent.Part part) {
        InstanceSymbol symbol = part.symbol();
        List<String> facts = new ArrayList<>();
        facts.add("a part of " + Markdown.word(symbol.owner().qualifiedName()));
        symbol.component()
                .ifPresent(each -> facts.add("a component " + Markdown.word(each.qualifiedName())));
        return facts;
    }

    @Override
    public List<String> variable(Referent.Variable variable) {
        return List.of(
                switch (variable.symbol().kind()) {
                    case AUTOMATON -> "a variable of the automaton";
                    case COMPONENT ->
                            isField(variable.symbol())
                                    ? "a variable of the component: its automaton writes it"
                                    : "a constant of the component";
                    case LOCAL -> "a name for a value among the statements of one step";
                    case SUITE -> "a name for a value in this suite";
                });
    }

    private boolean isField(VariableSymbol variable) {
        return models.workspace().components().stream()
                .filter(each -> each.signature().variables().contains(variable))
                .anyMatch(each -> each.fields().contains(variable));
    }

    /** What is known of one element need not be so of another one. */
    @Override
    public List<String> array(Referent.Array array) {
        List<String> facts = new ArrayList<>();
        facts.add((array.isWhole() ? "an array of " : "an element of an array of ") + array.size());
        if (!array.isWhole() || array.kind() != Referent.Kind.PORT) {
            facts.addAll(array.one().match(this));
        }
        return facts;
    }

    @Override
    public List<String> bound(Referent.Bound bound) {
        return List.of(
                bound.bound().giver() instanceof Expression.Let
                        ? "a name for a value"
                        : "a name for each value of a set");
    }

    @Override
    public List<String> parameter(Referent.Parameter parameter) {
        return List.of("a parameter of the component");
    }

    @Override
    public List<String> feature(Referent.Feature feature) {
        return List.of("a feature of " + Markdown.word(feature.component()));
    }

    @Override
    public List<String> state(Referent.State state) {
        AutomatonSymbol automaton = state.automaton();
        List<String> facts = new ArrayList<>();
        if (automaton.initials().stream()
                .map(InitialSymbol::state)
                .flatMap(Optional::stream)
                .anyMatch(state.symbol()::equals)) {
            facts.add("initial");
        }
        facts.add(
                "transitions: %d to it, %d from it"
                        .formatted(
                                count(state, TransitionSymbol::target),
                                count(state, TransitionSymbol::source)));
        return facts;
    }

    private static int count(
            Referent.State state,
            Function<TransitionSymbol, Optional<AutomatonSymbol.StateSymbol>> end) {
        return (int)
                state.automaton().transitions().stream()
                        .map(end)
                        .flatMap(Optional::stream)
                        .filter(state.symbol()::equals)
                        .count();
    }

    @Override
    public List<String> behaviour(Referent.Behaviour behaviour) {
        return List.of();
    }

    @Override
    public List<String> invariant(Referent.Invariant invariant) {
        return invariant.symbol().obstacle().stream()
                .map(why -> "without a meaning here: " + Markdown.text(why))
                .toList();
    }

    @Override
    public List<String> suite(Referent.Suite suite) {
        return List.of(number(suite.symbol().tests().size(), "test"));
    }

    @Override
    public List<String> test(Referent.Test test) {
        return List.of("a test of " + Markdown.word(test.symbol().suite().name()));
    }
}

package arcomat.editor.answer.shape;

import arcomat.source.Span;
import arcomat.symbols.bodies.AutomatonSymbol;
import arcomat.symbols.bodies.AutomatonSymbol.StateSymbol;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.occurrences.Referent;
import arcomat.symbols.signatures.Signature;
import arcomat.tree.Behaviour;
import arcomat.tree.Component;

import org.eclipse.lsp4j.SymbolKind;

import java.util.List;
import java.util.stream.Stream;

/** The outline of a component: what it declares itself, and what is declared in that. */
final class ComponentOutline {
    private static final String AUTOMATON = "automaton";

    private ComponentOutline() {}

    static OutlineEntry of(ComponentSymbol component) {
        return OutlineEntry.of(
                new Referent.Component(component.signature()),
                component.node().span(),
                Stream.of(
                                members(component.signature()),
                                parts(component),
                                component.innerComponents().stream().map(ComponentOutline::of),
                                component.ownInvariants().stream()
                                        .map(
                                                each ->
                                                        OutlineEntry.of(
                                                                new Referent.Invariant(each),
                                                                each.node().span(),
                                                                Stream.empty())),
                                component.ownAutomata().stream()
                                        .map(each -> automaton(each, keyword(each, component))))
                        .flatMap(each -> each));
    }

    private static Stream<OutlineEntry> members(Signature signature) {
        Stream<Referent> parameters =
                signature.ownParameters().stream().map(Referent.Parameter::new);
        Stream<Referent> ports = signature.ownPorts().stream().map(Referent.Port::new);
        Stream<Referent> variables = signature.ownVariables().stream().map(Referent.Variable::new);
        return lines(Stream.of(parameters, ports, variables).flatMap(each -> each));
    }

    /** Whatever has its component written at the same place is that component's line. */
    private static Stream<OutlineEntry> parts(ComponentSymbol component) {
        return lines(
                component.ownInstances().stream()
                        .filter(each -> !(each.node() instanceof Component))
                        .map(Referent.Part::new));
    }

    /** An array has one line. */
    private static Stream<OutlineEntry> lines(Stream<? extends Referent> declared) {
        return declared.map(Referent.Array::whole).distinct().map(OutlineEntry::of);
    }

    static OutlineEntry automaton(AutomatonSymbol automaton) {
        return automaton(automaton, AUTOMATON);
    }

    /** Of the language that it is written in. */
    private static String keyword(AutomatonSymbol automaton, ComponentSymbol component) {
        return component.node().elements(Behaviour.Foreign.class).stream()
                .filter(each -> each.span().equals(automaton.node().span()))
                .map(each -> each.keyword().text())
                .findFirst()
                .orElse(AUTOMATON);
    }

    private static OutlineEntry automaton(AutomatonSymbol automaton, String keyword) {
        Stream<Referent> ports = automaton.declaredPorts().stream().map(Referent.Port::new);
        Stream<Referent> variables = automaton.variables().stream().map(Referent.Variable::new);
        Stream<Referent> states =
                automaton.states().stream()
                        .filter(each -> isWritten(each, keyword))
                        .map(each -> new Referent.State(automaton, each));
        Stream<OutlineEntry> inside =
                lines(Stream.of(ports, variables, states).flatMap(each -> each));
        Span whole = automaton.node().span();
        return automaton
                .node()
                .name()
                .map(name -> OutlineEntry.of(new Referent.Behaviour(name), whole, inside))
                .orElseGet(() -> unnamed(keyword, whole, inside));
    }

    /** In another language no word need stand for a state. */
    private static boolean isWritten(StateSymbol state, String keyword) {
        return keyword.equals(AUTOMATON) || state.nameSpan().text().equals(state.name());
    }

    private static OutlineEntry unnamed(String name, Span whole, Stream<OutlineEntry> inside) {
        List<OutlineEntry> lines = OutlineEntry.inTextOrder(inside);
        return new OutlineEntry(name, SymbolKind.Enum, whole, whole.firstLine(), "", lines);
    }
}

package arcomat.editor.answer.fact;

import arcomat.source.Span;
import arcomat.symbols.bodies.InstanceSymbol;
import arcomat.symbols.expressions.DeclaredValue;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.occurrences.Referent;
import arcomat.symbols.occurrences.ReferentCases;
import arcomat.tree.Element;
import arcomat.tree.Node;
import arcomat.tree.Stereotype;

import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;

/** How something is declared, in one line of the language. */
record DeclarationLine() implements ReferentCases<String> {

    @Override
    public String packageName(Referent.PackageName name) {
        return "package " + name.qualifiedName();
    }

    @Override
    public String component(Referent.Component component) {
        Span name = component.signature().nameSpan();
        return name.text().equals(component.name())
                ? head(component.signature().node().span(), name)
                : "component " + component.name(); // a guest has made it of another text
    }

    /** All in front of the body. */
    private static String head(Span whole, Span name) {
        String text = whole.file().text();
        int brace = text.indexOf('{', name.end());
        int end = brace < 0 ? whole.end() : brace;
        return text.substring(whole.start(), end).strip();
    }

    @Override
    public String diagram(Referent.Diagram diagram) {
        return "classdiagram " + diagram.name();
    }

    @Override
    public String type(Referent.Type type) {
        return type.symbol().node().span().text();
    }

    @Override
    public String builtin(Referent.Builtin type) {
        return type.name();
    }

    @Override
    public String typeParameter(Referent.TypeParameter parameter) {
        return parameter.variable().node().span().text();
    }

    @Override
    public String constant(Referent.Constant constant) {
        return constant.type().text() + "." + constant.name();
    }

    @Override
    public String attribute(Referent.Attribute attribute) {
        return attribute.symbol().type().text() + " " + attribute.name();
    }

    @Override
    public String port(Referent.Port port) {
        PortSymbol symbol = port.symbol();
        String direction = symbol.isInput() ? "in" : "out";
        return "port %s%s %s %s"
                .formatted(
                        stereotypes(symbol.stereotypes()),
                        direction,
                        symbol.type().text(),
                        symbol.name());
    }

    private static String stereotypes(List<Stereotype> all) {
        return all.isEmpty()
                ? ""
                : all.stream()
                        .map(each -> each.span().text())
                        .collect(Collectors.joining(", ", "<<", ">> "));
    }

    @Override
    public String part(Referent.Part part) {
        InstanceSymbol symbol = part.symbol();
        return "component %s %s".formatted(type(symbol.node(), part), symbol.name());
    }

    /** As it is written, with its arguments. */
    private static String type(Node node, Referent.Part part) {
        return node instanceof Element.Subcomponent written
                ? written.type().span().text() + arguments(written)
                : part.typeReferent().map(Referent::name).orElse("");
    }

    private static String arguments(Element.Subcomponent written) {
        return written.arguments().isEmpty()
                ? ""
                : written.arguments().stream()
                        .map(each -> each.span().text())
                        .collect(Collectors.joining(", ", "(", ")"));
    }

    @Override
    public String variable(Referent.Variable variable) {
        return value(variable.symbol(), variable.symbol().node().initial());
    }

    /** Of an element what that one is, of all of them what is written. */
    @Override
    public String array(Referent.Array array) {
        String line = array.one().match(this);
        return array.isWhole()
                ? line.replace(array.one().name(), "%s[%s]".formatted(array.name(), array.size()))
                : line;
    }

    /** What stands in front of the colon, or of {@code in}. */
    @Override
    public String bound(Referent.Bound bound) {
        Span giver = bound.bound().giver().span();
        return giver.file().span(giver.start(), bound.bound().source().end()).text();
    }

    @Override
    public String parameter(Referent.Parameter parameter) {
        return value(parameter.symbol(), parameter.symbol().node().initial());
    }

    static String value(DeclaredValue value, Optional<? extends Node> initial) {
        return value.type().text()
                + " "
                + value.name()
                + initial.map(node -> " = " + node.span().text()).orElse("");
    }

    @Override
    public String feature(Referent.Feature feature) {
        return "feature " + feature.name();
    }

    @Override
    public String state(Referent.State state) {
        return "state " + state.symbol().node().span().text();
    }

    @Override
    public String behaviour(Referent.Behaviour behaviour) {
        return "automaton " + behaviour.name();
    }

    @Override
    public String invariant(Referent.Invariant invariant) {
        return invariant.symbol().node().span().text();
    }

    @Override
    public String suite(Referent.Suite suite) {
        return head(suite.symbol().node().span(), suite.symbol().node().component().span());
    }

    @Override
    public String test(Referent.Test test) {
        return "test " + test.name();
    }
}

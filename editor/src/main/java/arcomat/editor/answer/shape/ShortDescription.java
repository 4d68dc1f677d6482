package arcomat.editor.answer.shape;

import arcomat.symbols.occurrences.Referent;
import arcomat.symbols.occurrences.ReferentCases;
import arcomat.tree.ClassDiagram.ClassDefinition;
import arcomat.tree.ClassDiagram.EnumDefinition;

/** What stands beside a name in a list: mostly its type. */
public record ShortDescription() implements ReferentCases<String> {
    @Override
    public String packageName(Referent.PackageName name) {
        return "package";
    }

    @Override
    public String component(Referent.Component component) {
        return "component";
    }

    @Override
    public String diagram(Referent.Diagram diagram) {
        return "class diagram";
    }

    @Override
    public String type(Referent.Type type) {
        if (type.symbol().node() instanceof ClassDefinition) {
            return "class";
        }
        return type.symbol().node() instanceof EnumDefinition ? "enum" : "opaque type";
    }

    @Override
    public String builtin(Referent.Builtin type) {
        return "built-in type";
    }

    @Override
    public String typeParameter(Referent.TypeParameter parameter) {
        return "type parameter";
    }

    @Override
    public String constant(Referent.Constant constant) {
        return constant.type().text();
    }

    @Override
    public String attribute(Referent.Attribute attribute) {
        return attribute.symbol().type().text();
    }

    @Override
    public String port(Referent.Port port) {
        return (port.symbol().isInput() ? "in " : "out ") + port.symbol().type().text();
    }

    @Override
    public String part(Referent.Part part) {
        return part.typeReferent().map(Referent::name).orElse("");
    }

    @Override
    public String variable(Referent.Variable variable) {
        return variable.symbol().type().text();
    }

    @Override
    public String array(Referent.Array array) {
        String one = array.one().match(this);
        return array.isWhole() ? "%s [%s]".formatted(one, array.size()) : one;
    }

    @Override
    public String bound(Referent.Bound bound) {
        return "value";
    }

    @Override
    public String parameter(Referent.Parameter parameter) {
        return parameter.symbol().type().text();
    }

    @Override
    public String feature(Referent.Feature feature) {
        return "feature";
    }

    @Override
    public String state(Referent.State state) {
        return "state";
    }

    @Override
    public String behaviour(Referent.Behaviour behaviour) {
        return "automaton";
    }

    @Override
    public String invariant(Referent.Invariant invariant) {
        return "invariant";
    }

    @Override
    public String suite(Referent.Suite suite) {
        return suite.symbol().node().component().text();
    }

    @Override
    public String test(Referent.Test test) {
        return "test";
    }
}

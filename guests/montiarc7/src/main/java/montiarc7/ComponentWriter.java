package montiarc7;

import montiarc7.grammar.MontiArc7Parser.AutoElementContext;
import montiarc7.grammar.MontiArc7Parser.AutomatonElementContext;
import montiarc7.grammar.MontiArc7Parser.ComponentContext;
import montiarc7.grammar.MontiArc7Parser.ComputeElementContext;
import montiarc7.grammar.MontiArc7Parser.ConditionElementContext;
import montiarc7.grammar.MontiArc7Parser.ConnectorElementContext;
import montiarc7.grammar.MontiArc7Parser.ConstraintElementContext;
import montiarc7.grammar.MontiArc7Parser.ElementContext;
import montiarc7.grammar.MontiArc7Parser.FeatureElementContext;
import montiarc7.grammar.MontiArc7Parser.FieldElementContext;
import montiarc7.grammar.MontiArc7Parser.GroupElementContext;
import montiarc7.grammar.MontiArc7Parser.InitElementContext;
import montiarc7.grammar.MontiArc7Parser.InnerElementContext;
import montiarc7.grammar.MontiArc7Parser.InstanceElementContext;
import montiarc7.grammar.MontiArc7Parser.LiteralExpressionContext;
import montiarc7.grammar.MontiArc7Parser.ModesElementContext;
import montiarc7.grammar.MontiArc7Parser.NameContext;
import montiarc7.grammar.MontiArc7Parser.ParameterContext;
import montiarc7.grammar.MontiArc7Parser.ParentContext;
import montiarc7.grammar.MontiArc7Parser.PortDeclarationContext;
import montiarc7.grammar.MontiArc7Parser.PortsElementContext;
import montiarc7.grammar.MontiArc7Parser.SoleModeElementContext;
import montiarc7.grammar.MontiArc7Parser.TypeParameterContext;
import montiarc7.grammar.MontiArc7Parser.VariationElementContext;
import montiarc7.source.Folder;
import montiarc7.source.Lack;
import montiarc7.source.Lacks;
import montiarc7.source.Placed;
import montiarc7.source.Placed.Side;
import montiarc7.source.TypeNames;
import montiarc7.statement.ActionWriter;
import montiarc7.statement.ExpressionWriter;
import montiarc7.statement.Known;
import montiarc7.statement.Scope;

import org.antlr.v4.runtime.tree.ParseTree;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.TreeSet;
import java.util.stream.Collectors;

/** One component in Arcomat's words. */
final class ComponentWriter {
    private final ComponentContext component;
    private final MontiArcText text;
    private final Folder folder;
    private final TypeNames types;
    private final Lacks lacks;
    private final Variants variants;
    private final Features features;
    private final Switches switches;
    private final Scope scope;

    ComponentWriter(
            ComponentContext component,
            MontiArcText text,
            Folder folder,
            TypeNames types,
            Lacks lacks) {
        this.component = component;
        this.text = text;
        this.folder = folder;
        this.types = types;
        this.lacks = lacks;
        this.variants = new Variants(component, lacks);
        this.features = new Features(component, folder, lacks);
        this.switches = new Switches(component, folder);
        types.enter(component);
        this.scope = scope(List.of());
    }

    /** What is known on some sides of variations. */
    private Scope scope(List<Side> sides) {
        return new Scope(
                types,
                folder.ports(component, "in", sides),
                folder.ports(component, "out", sides),
                Set.of(),
                Known.NOTHING,
                Declared.in(component, sides),
                variants.isByEvents(sides),
                lacks);
    }

    String write() {
        StringBuilder written = new StringBuilder(head());
        if (variants.behave()) {
            variants.byEvents().ifPresent(each -> written.append(timing(each)));
        } else if (variants.isSynchronousInterface()) {
            written.append(timing(false));
        }
        if (hasInner()) {
            written.append("autoinstantiate off;\n");
        }
        written.append(elements(component.element(), List.of()));
        variants.elements().stream()
                .filter(each -> each.element() instanceof InitElementContext)
                .filter(each -> !variants.goOn(each))
                .forEach(
                        each ->
                                lacks.missing(
                                        Lack.STRUCTURE,
                                        component.name(0),
                                        "'init' stands alone; say what is done afterwards, too"));
        return written.append("}\n").toString();
    }

    private static String timing(boolean byEvents) {
        return "timing " + (byEvents ? "untimed" : "instant") + ";\n";
    }

    private boolean hasInner() {
        return variants.elements().stream()
                .anyMatch(each -> each.element() instanceof InnerElementContext);
    }

    private String head() {
        StringBuilder head = new StringBuilder("component ").append(component.name(0).getText());
        if (component.typeParameters() != null) {
            head.append(
                    component.typeParameters().typeParameter().stream()
                            .map(this::typeParameter)
                            .collect(Collectors.joining(", ", "<", ">")));
        }
        List<String> parameters =
                component.parameters() == null
                        ? List.of()
                        : component.parameters().parameter().stream()
                                .filter(each -> !switches.isOne(each))
                                .map(this::parameter)
                                .toList();
        if (!parameters.isEmpty()) {
            head.append("(").append(String.join(", ", parameters)).append(")");
        }
        if (component.parent().size() > 1) {
            lacks.missing(
                    Lack.PARENTS, component.parent(1), "a component of Arcomat extends one other");
        }
        if (!component.parent().isEmpty()) {
            head.append(" extends ").append(parent(component.parent(0)));
        }
        head.append(" {\n");
        if (!switches.names().isEmpty()) {
            String all = String.join(", ", new TreeSet<>(switches.names()));
            head.append("feature ").append(all).append(";\n").append(switches.constraints());
        }
        if (!features.open().isEmpty()) {
            head.append("feature ").append(String.join(", ", features.open())).append(";\n");
        }
        return head.toString();
    }

    private String parent(ParentContext parent) {
        Optional<ComponentContext> known = folder.component(parent.type().qname().getText());
        if (known.filter(this::hasSwitches).isPresent()) {
            lacks.missing(
                    Lack.VARIABILITY,
                    parent,
                    "'%s' has variants, which a component that extends it cannot choose"
                            .formatted(parent.type().getText()));
        } else {
            known.ifPresent(
                    each ->
                            new ParentArguments(parent, each, OpenFeatures.all(each, folder), lacks)
                                    .check());
        }
        String given = parts(scope).given(parent.arguments());
        boolean isDefault =
                given.isEmpty() && known.filter(each -> each.parameters() != null).isPresent();
        return types.component(parent.type()) + (isDefault ? "()" : given);
    }

    private boolean hasSwitches(ComponentContext component) {
        return !new Switches(component, folder).names().isEmpty();
    }

    private String parameter(ParameterContext parameter) {
        String declared = types.message(parameter.type()) + " " + parameter.name().getText();
        if (parameter.expression() instanceof LiteralExpressionContext literal
                && types.isOpaque(parameter.type())) {
            lacks.missing(
                    Lack.EXPRESSION,
                    literal,
                    "'%s' is no value of '%s', which is defined in no class diagram here; give it to the parts, or use another type"
                            .formatted(literal.getText(), parameter.type().getText()));
        }
        return parameter.expression() == null
                ? declared
                : declared + " = " + new ExpressionWriter(scope).write(parameter.expression());
    }

    private String typeParameter(TypeParameterContext parameter) {
        String name = parameter.name().getText();
        String bounds =
                parameter.type().stream()
                        .flatMap(each -> types.bound(each).stream())
                        .collect(Collectors.joining(" & "));
        return bounds.isEmpty() ? name : name + " extends " + bounds;
    }

    private PartWriter parts(Scope here) {
        return new PartWriter(folder, here, features);
    }

    private String element(ElementContext element, List<Side> sides) {
        if (element instanceof PortsElementContext ports) {
            return ports(ports, sides);
        } else if (element instanceof InnerElementContext inner) {
            return inner(inner.component());
        } else if (element instanceof ConnectorElementContext connector) {
            return connector(connector);
        } else if (element instanceof FieldElementContext field) {
            return field(field, scope(sides));
        } else if (element instanceof InstanceElementContext instance) {
            return parts(scope(sides)).write(instance);
        } else if (element instanceof AutoElementContext auto) {
            return auto.getChild(0).getText().equals("autoconnect")
                    ? "autoconnect " + auto.name().getText() + ";\n"
                    : "";
        } else if (element instanceof VariationElementContext variation) {
            return variation(variation, sides);
        } else if (element instanceof GroupElementContext group) {
            return elements(group.element(), sides);
        } else if (element instanceof SoleModeElementContext mode) {
            return elements(mode.element(), sides);
        } else if (element instanceof FeatureElementContext feature) {
            return feature.name().stream()
                    .map(ParseTree::getText)
                    .collect(Collectors.joining(", ", "feature ", ";\n"));
        } else if (element instanceof ConstraintElementContext constraint) {
            return features.constraint(constraint);
        } else if (element instanceof ConditionElementContext condition) {
            lacks.note(
                    Lack.UNCHECKED,
                    condition.expression(),
                    "this condition is left out: runs of the converted model do not check it");
        } else if (element instanceof ModesElementContext) {
            lacks.missing(
                    Lack.MODES,
                    element,
                    "modes are not converted: what is connected does not change while a model"
                            + " runs");
        }
        return behaviour(element, sides);
    }

    private String elements(List<ElementContext> elements, List<Side> sides) {
        return FieldOrder.of(elements).stream()
                .map(each -> text.comments(each) + element(each, sides))
                .collect(Collectors.joining());
    }

    private String variation(VariationElementContext variation, List<Side> sides) {
        if (Placed.isDecided(variation)) {
            return elements(Placed.decided(variation), sides);
        }
        String condition = features.condition(variation.expression());
        String then = elements(variation.element(), 0, Placed.and(sides, variation, true));
        if (variation.element().size() == 1) {
            return "varif (%s) {%n%s}%n".formatted(condition, then);
        }
        String other = elements(variation.element(), 1, Placed.and(sides, variation, false));
        return "varif (%s) {%n%s} else {%n%s}%n".formatted(condition, then, other);
    }

    private String elements(List<ElementContext> both, int at, List<Side> sides) {
        return elements(List.of(both.get(at)), sides);
    }

    private static String connector(ConnectorElementContext connector) {
        return connector.portReference().stream()
                .skip(1)
                .map(ParseTree::getText)
                .collect(
                        Collectors.joining(
                                ", ",
                                "connect " + connector.portReference(0).getText() + " -> ",
                                ";\n"));
    }

    private String field(FieldElementContext field, Scope here) {
        return field.field().stream()
                .map(
                        each ->
                                each.name().getText()
                                        + " = "
                                        + new ExpressionWriter(here).write(each.expression()))
                .collect(Collectors.joining(", ", types.message(field.type()) + " ", ";\n"));
    }

    private String behaviour(ElementContext element, List<Side> sides) {
        Scope here = scope(sides);
        Set<String> late = variants.late(here.outputs(), sides);
        String timing = variants.byEvents().isPresent() ? "" : timing(variants.isByEvents(sides));
        if (element instanceof AutomatonElementContext automaton) {
            Machine machine = new Machine(automaton.machineElement(), lacks);
            return timing
                    + new MachineWriter(machine, text, here, variants.isByEvents(sides))
                            .write(variants.before(sides), late, automaton);
        } else if (element instanceof ComputeElementContext compute) {
            String start =
                    variants.before(sides)
                            .map(each -> new StartWriter(here, late).write(List.of(each)))
                            .orElse("");
            return timing
                    + (start.isBlank() ? "" : "init {" + start + "}\n")
                    + "<<completion = \"ignore\">> compute {"
                    + new ActionWriter(here).write(List.of(compute.block()))
                    + "}\n";
        }
        return "";
    }

    private String ports(PortsElementContext ports, List<Side> sides) {
        List<String> all = new ArrayList<>();
        for (PortDeclarationContext each : ports.portDeclaration()) {
            String direction = each.direction.getText();
            String type = types.message(each.type());
            for (NameContext name : each.name()) {
                boolean late = direction.equals("out") && variants.isLate(name, sides);
                String delay = late ? "<<delay = \"1\">> " : "";
                all.add(delay + direction + " " + type + " " + name.getText());
            }
        }
        return all.stream().collect(Collectors.joining(",\n", "port ", ";\n"));
    }

    private String inner(ComponentContext inner) {
        if (!OpenFeatures.declared(inner).isEmpty() || hasSwitches(inner)) {
            lacks.missing(
                    Lack.VARIABILITY,
                    inner.name(0),
                    "'%s' has features; give it a file of its own"
                            .formatted(inner.name(0).getText()));
        }
        StringBuilder written =
                new StringBuilder(new ComponentWriter(inner, text, folder, types, lacks).write());
        for (int i = 1; i < inner.name().size(); i++) {
            written.append("component ")
                    .append(inner.name(0).getText())
                    .append(' ')
                    .append(inner.name(i).getText())
                    .append(";\n");
        }
        return written.toString();
    }
}

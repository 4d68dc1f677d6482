package montiarc7;

import montiarc7.MontiArc7Parser.ArgumentsContext;
import montiarc7.MontiArc7Parser.AutoElementContext;
import montiarc7.MontiArc7Parser.AutomatonElementContext;
import montiarc7.MontiArc7Parser.BlockContext;
import montiarc7.MontiArc7Parser.ComponentContext;
import montiarc7.MontiArc7Parser.ComputeElementContext;
import montiarc7.MontiArc7Parser.ConnectorElementContext;
import montiarc7.MontiArc7Parser.ElementContext;
import montiarc7.MontiArc7Parser.FieldElementContext;
import montiarc7.MontiArc7Parser.InitElementContext;
import montiarc7.MontiArc7Parser.InnerElementContext;
import montiarc7.MontiArc7Parser.InstanceElementContext;
import montiarc7.MontiArc7Parser.PortDeclarationContext;
import montiarc7.MontiArc7Parser.PortsElementContext;
import montiarc7.MontiArc7Parser.TypeParameterContext;

import org.antlr.v4.runtime.tree.ParseTree;

import java.util.ArrayList;
import java.util.HashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;

/** One component in Arcomat's words. */
final class ComponentWriter {
    private final ComponentContext component;
    private final MontiArcText text;
    private final Folder folder;
    private final TypeNames types;
    private final Lacks lacks;
    private final Timing timing;
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
        this.timing = new Timing(component, lacks);
        types.enter(component);
        this.scope =
                new Scope(
                        types,
                        folder.ports(component, "in"),
                        folder.ports(component, "out"),
                        Set.of(),
                        lacks);
    }

    String write() {
        StringBuilder written = new StringBuilder(head());
        if (timing.behaves()) {
            written.append("timing ")
                    .append(timing.isByEvents() ? "untimed" : "instant")
                    .append(";\n");
        }
        if (component.element().stream().anyMatch(InnerElementContext.class::isInstance)) {
            written.append("autoinstantiate off;\n");
        }
        boolean hasCompute = false;
        for (ElementContext each : component.element()) {
            written.append(text.comments(each)).append(element(each));
            hasCompute |=
                    each instanceof ComputeElementContext
                            || each instanceof AutomatonElementContext;
        }
        if (!hasCompute && init().isPresent()) {
            lacks.missing(
                    Lack.STRUCTURE,
                    component.name(0),
                    "'init' stands alone; say what is done afterwards, too");
        }
        return written.append("}\n").toString();
    }

    private String head() {
        StringBuilder head = new StringBuilder("component ").append(component.name(0).getText());
        if (component.typeParameters() != null) {
            head.append(
                    component.typeParameters().typeParameter().stream()
                            .map(this::typeParameter)
                            .collect(Collectors.joining(", ", "<", ">")));
        }
        if (component.parameters() != null) {
            head.append(
                    component.parameters().parameter().stream()
                            .map(
                                    each ->
                                            types.message(each.type())
                                                    + " "
                                                    + each.name().getText()
                                                    + (each.expression() == null
                                                            ? ""
                                                            : " = "
                                                                    + new ExpressionWriter(scope)
                                                                            .write(
                                                                                    each
                                                                                            .expression())))
                            .collect(Collectors.joining(", ", "(", ")")));
        }
        if (component.parent().size() > 1) {
            lacks.missing(
                    Lack.PARENTS, component.parent(1), "a component of Arcomat extends one other");
        }
        if (!component.parent().isEmpty()) {
            var parent = component.parent(0);
            head.append(" extends ")
                    .append(types.component(parent.type()))
                    .append(given(parent.arguments()));
        }
        return head.append(" {\n").toString();
    }

    private String typeParameter(TypeParameterContext parameter) {
        String name = parameter.name().getText();
        return parameter.type().isEmpty()
                ? name
                : parameter.type().stream()
                        .map(types::message)
                        .collect(Collectors.joining(" & ", name + " extends ", ""));
    }

    private String given(ArgumentsContext arguments) {
        if (arguments == null || arguments.argument().isEmpty()) {
            return "";
        }
        return arguments.argument().stream()
                .map(
                        each ->
                                (each.name() == null ? "" : each.name().getText() + " = ")
                                        + new ExpressionWriter(scope).write(each.expression()))
                .collect(Collectors.joining(", ", "(", ")"));
    }

    private String element(ElementContext element) {
        if (element instanceof PortsElementContext ports) {
            return ports(ports);
        } else if (element instanceof InnerElementContext inner) {
            return inner(inner.component());
        } else if (element instanceof ConnectorElementContext connector) {
            return connector.portReference().stream()
                    .skip(1)
                    .map(ParseTree::getText)
                    .collect(
                            Collectors.joining(
                                    ", ",
                                    "connect " + connector.portReference(0).getText() + " -> ",
                                    ";\n"));
        } else if (element instanceof FieldElementContext field) {
            return field.field().stream()
                    .map(
                            each ->
                                    each.name().getText()
                                            + " = "
                                            + new ExpressionWriter(scope).write(each.expression()))
                    .collect(Collectors.joining(", ", types.message(field.type()) + " ", ";\n"));
        } else if (element instanceof InstanceElementContext instance) {
            String type = types.component(instance.type());
            return instance.instance().stream()
                    .map(
                            each ->
                                    "component "
                                            + type
                                            + given(
                                                    each.arguments() == null
                                                            ? instance.arguments()
                                                            : each.arguments())
                                            + " "
                                            + each.name().getText()
                                            + ";\n")
                    .collect(Collectors.joining());
        } else if (element instanceof AutoElementContext auto) {
            return auto.getChild(0).getText().equals("autoconnect")
                    ? "autoconnect " + auto.name().getText() + ";\n"
                    : "";
        } else if (element instanceof AutomatonElementContext automaton) {
            Machine machine = new Machine(automaton.machineElement(), lacks);
            return new MachineWriter(machine, text, scope, timing.isByEvents())
                    .write(init(), delayed(), automaton);
        } else if (element instanceof ComputeElementContext compute) {
            return compute(compute);
        }
        return refused(element);
    }

    private String refused(ElementContext element) {
        String word = element.getStart().getText();
        if (element instanceof MontiArc7Parser.ModesElementContext) {
            lacks.missing(
                    Lack.MODES,
                    element,
                    "modes are not converted: what is connected does not change while a model"
                            + " runs");
        } else if (element instanceof MontiArc7Parser.FeatureElementContext
                || element instanceof MontiArc7Parser.VariationElementContext
                || element instanceof MontiArc7Parser.ConstraintElementContext) {
            lacks.missing(
                    Lack.VARIABILITY,
                    element,
                    "'%s': variants of a component are not converted; write a component for each"
                            .formatted(word));
        } else if (element instanceof MontiArc7Parser.GroupElementContext group) {
            return group.element().stream().map(this::element).collect(Collectors.joining());
        }
        return "";
    }

    private String ports(PortsElementContext ports) {
        List<String> all = new ArrayList<>();
        for (PortDeclarationContext each : ports.portDeclaration()) {
            String direction = each.direction.getText();
            String type = types.message(each.type());
            each.name()
                    .forEach(
                            name -> {
                                boolean late =
                                        direction.equals("out")
                                                && timing.behaves()
                                                && timing.isDelayed(name.getText());
                                if (late && timing.isByEvents()) {
                                    lacks.note(
                                            Lack.START,
                                            name,
                                            "events have no delay: '%s' is sent at once"
                                                    .formatted(name.getText()));
                                }
                                String delay =
                                        late && !timing.isByEvents() ? "<<delay = \"1\">> " : "";
                                all.add(delay + direction + " " + type + " " + name.getText());
                            });
        }
        return all.stream().collect(Collectors.joining(",\n", "port ", ";\n"));
    }

    private String inner(ComponentContext inner) {
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

    private String compute(ComputeElementContext compute) {
        String start =
                init().map(each -> new StartWriter(scope, delayed()).write(List.of(each)))
                        .orElse("");
        String done = new ActionWriter(scope).write(List.of(compute.block()));
        return (start.isBlank() ? "" : "init {" + start + "}\n")
                + "<<completion = \"ignore\">> compute {"
                + done
                + "}\n";
    }

    private Optional<BlockContext> init() {
        return component.element().stream()
                .filter(InitElementContext.class::isInstance)
                .map(each -> ((InitElementContext) each).block())
                .findFirst();
    }

    private Set<String> delayed() {
        Set<String> names = new HashSet<>();
        if (!timing.isByEvents()) {
            scope.outputs().stream().filter(timing::isDelayed).forEach(names::add);
        }
        return names;
    }
}

package arcomat.symbols.signatures;

import arcomat.symbols.expressions.ExpressionTyping;
import arcomat.symbols.expressions.ParameterSymbol;
import arcomat.symbols.expressions.PortSymbol;
import arcomat.symbols.expressions.ValueScope;
import arcomat.symbols.expressions.VariableSymbol;
import arcomat.symbols.names.Names;
import arcomat.symbols.names.Resolution;
import arcomat.symbols.names.TypeSymbol;
import arcomat.tree.Component.Parameter;
import arcomat.tree.Element;
import arcomat.tree.Name;
import arcomat.tree.Stereotype;
import arcomat.tree.Variable;

import java.util.ArrayList;
import java.util.List;

/** The ports, parameters and constants that are declared in one component. */
final class Members {
    private final Signature component;

    Members(Signature component) {
        this.component = component;
    }

    List<PortSymbol> ports() {
        List<PortSymbol> ports = new ArrayList<>();
        for (Element.Ports declaration : component.node().elements(Element.Ports.class)) {
            for (Element.Port port : declaration.ports()) {
                List<Stereotype> stereotypes = new ArrayList<>(port.stereotypes());
                stereotypes.addAll(declaration.stereotypes());
                addPorts(port, stereotypes, ports);
            }
        }
        return List.copyOf(ports);
    }

    private void addPorts(Element.Port port, List<Stereotype> stereotypes, List<PortSymbol> ports) {
        Resolution<TypeSymbol> type = component.resolveType(port.type());
        List<Name> names = port.names();
        if (names.isEmpty()) {
            String typeName = port.type().name().last().text();
            names = List.of(new Name(port.type().span(), Names.implicit(typeName)));
        }
        for (Name name : names) {
            ports.add(
                    new PortSymbol(
                            name.text(),
                            name.span(),
                            port.names().isEmpty(),
                            port.direction(),
                            port.type(),
                            type,
                            stereotypes,
                            component.defaultDelay()));
        }
    }

    List<ParameterSymbol> parameters() {
        List<ParameterSymbol> parameters = new ArrayList<>();
        ValueScope earlier = component.emptyScope();
        for (Parameter node : component.node().parameters()) {
            ParameterSymbol parameter =
                    new ParameterSymbol(
                            node, component.resolveType(node.type()), ExpressionTyping.at(earlier));
            parameters.add(parameter);
            earlier = earlier.with(List.of(parameter));
        }
        return List.copyOf(parameters);
    }

    List<VariableSymbol> variables() {
        List<VariableSymbol> variables = new ArrayList<>();
        for (Element.Variables node : component.node().elements(Element.Variables.class)) {
            Resolution<TypeSymbol> type = component.resolveType(node.type());
            for (Variable variable : node.variables()) {
                variables.add(
                        new VariableSymbol(
                                VariableSymbol.Kind.COMPONENT,
                                variable,
                                type,
                                ExpressionTyping.at(
                                        component.parameterScope().with(List.copyOf(variables)))));
            }
        }
        return List.copyOf(variables);
    }
}

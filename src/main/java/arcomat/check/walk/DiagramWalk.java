package arcomat.check.walk;

import arcomat.check.law.Carrier;
import arcomat.check.law.Check;
import arcomat.check.law.Check.Context;
import arcomat.check.walk.Listeners.Listener;
import arcomat.symbols.names.ClassSymbol;
import arcomat.symbols.names.DefinedType;
import arcomat.symbols.names.DiagramSymbol;
import arcomat.symbols.names.EnumSymbol;
import arcomat.tree.ClassDiagram;

/** The part of the walk that goes through class diagrams. */
record DiagramWalk(Listeners listeners, StereotypeWalk stereotypes, ExpressionWalk expressions) {

    void classDiagram(DiagramSymbol diagram, Context context) {
        ClassDiagram node = diagram.node();
        stereotypes.visit(node.stereotypes(), Carrier.CLASS_DIAGRAM, node, context);
        for (Listener<Check.OnClassDiagram> each : listeners.onClassDiagram) {
            each.check().check(diagram, context, each.findings());
        }
        diagram.types().forEach(type -> type(type, context));
        node.associations().forEach(each -> association(each, context));
    }

    private void type(DefinedType type, Context context) {
        stereotypes.visit(type.node().stereotypes(), Carrier.TYPE, type.node(), context);
        if (type instanceof ClassSymbol symbol) {
            object(symbol, context);
        } else if (type instanceof EnumSymbol symbol) {
            for (Listener<Check.OnEnum> each : listeners.onEnum) {
                each.check().check(symbol.node(), context, each.findings());
            }
        }
        mentioned(type.node());
    }

    private void object(ClassSymbol symbol, Context context) {
        for (Listener<Check.OnClass> each : listeners.onClass) {
            each.check().check(symbol, context, each.findings());
        }
        symbol.node().superClass().ifPresent(above -> expressions.type(above, context));
        for (ClassDiagram.Attribute attribute : symbol.node().attributes()) {
            stereotypes.visit(attribute.stereotypes(), Carrier.ATTRIBUTE, attribute, context);
            expressions.type(attribute.type(), context);
        }
    }

    private void association(ClassDiagram.Association association, Context context) {
        stereotypes.visit(association.stereotypes(), Carrier.ASSOCIATION, association, context);
        expressions.type(association.left().type(), context);
        expressions.type(association.right().type(), context);
    }

    /** Names of types that no law is about, and that may be why something is imported. */
    private void mentioned(ClassDiagram.TypeDefinition type) {
        type.interfaces().forEach(each -> expressions.name(each.name()));
        type.members().forEach(this::mentioned);
    }

    private void mentioned(ClassDiagram.Member member) {
        if (member instanceof ClassDiagram.Attribute attribute) {
            expressions.name(attribute.type().name());
        } else if (member instanceof ClassDiagram.Method method) {
            method.result().ifPresent(result -> expressions.name(result.name()));
            method.parameters().forEach(each -> expressions.name(each.type().name()));
            method.thrown().forEach(each -> expressions.name(each.name()));
        }
    }
}

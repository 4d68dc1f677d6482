package arcomat.symbols.occurrences;

import arcomat.symbols.names.ClassSymbol;
import arcomat.symbols.names.ClassSymbol.AttributeSymbol;
import arcomat.symbols.names.DefinedType;
import arcomat.symbols.names.DiagramSymbol;
import arcomat.symbols.names.EnumSymbol;
import arcomat.symbols.names.UnitScope;
import arcomat.tree.ClassDiagram;

/** Names in a class diagram. */
record DiagramPlaces(NamePlaces places, UnitScope scope) {

    void in(DiagramSymbol diagram) {
        places.declared(
                diagram.node().name().span(), Referent.diagramOf(diagram.unit(), diagram.node()));
        for (DefinedType type : diagram.types()) {
            places.declared(type.nameSpan(), new Referent.Type(type));
            if (type instanceof EnumSymbol enumeration) {
                constants(enumeration);
            } else if (type instanceof ClassSymbol symbol) {
                attributes(symbol);
            }
            type.node().interfaces().forEach(above -> places.type(above, scope::type));
        }
        for (ClassDiagram.Association association : diagram.node().associations()) {
            places.type(association.left().type(), scope::type);
            places.type(association.right().type(), scope::type);
        }
    }

    private void constants(EnumSymbol type) {
        for (int i = 0; i < type.constants().size(); i++) {
            places.declared(type.node().constants().get(i).span(), new Referent.Constant(type, i));
        }
    }

    private void attributes(ClassSymbol type) {
        type.node().superClass().ifPresent(above -> places.type(above, scope::type));
        for (AttributeSymbol attribute : type.attributes()) {
            if (attribute.owner() == type) {
                places.type(attribute.node().type(), scope::type);
                places.declared(attribute.node().name().span(), new Referent.Attribute(attribute));
            }
        }
    }
}

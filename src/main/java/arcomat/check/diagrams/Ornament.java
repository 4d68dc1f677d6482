package arcomat.check.diagrams;

import arcomat.source.Span;
import arcomat.tree.ClassDiagram;
import arcomat.tree.ClassDiagram.Attribute;
import arcomat.tree.ClassDiagram.ClassDefinition;
import arcomat.tree.ClassDiagram.EnumDefinition;
import arcomat.tree.ClassDiagram.Member;
import arcomat.tree.ClassDiagram.Method;
import arcomat.tree.Node;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;

/**
 * Something in the definition of a type that means nothing here.
 *
 * @param words how messages call it
 */
record Ornament(Span place, String words) {

    /** In the order of the text. */
    static List<Ornament> of(ClassDiagram.TypeDefinition type) {
        List<Ornament> found = new ArrayList<>();
        type.modifiers().forEach(each -> found.add(of(each, "'" + each + "'")));
        type.interfaces().forEach(each -> found.add(of(each, "interface '" + each.name() + "'")));
        boolean hasAttributes = type instanceof ClassDefinition;
        type.members().forEach(each -> member(each, hasAttributes, found));
        if (type instanceof EnumDefinition definition) {
            definition
                    .arguments()
                    .forEach(
                            each -> found.add(of(each, "the values of '" + each.constant() + "'")));
        }
        found.sort(Comparator.comparingInt(each -> each.place().start()));
        return found;
    }

    private static Ornament of(Node node, String words) {
        return new Ornament(node.span(), words);
    }

    private static void member(Member member, boolean hasAttributes, List<Ornament> found) {
        if (member instanceof Attribute attribute && hasAttributes) {
            attribute.modifiers().forEach(each -> found.add(of(each, "'" + each + "'")));
            attribute
                    .value()
                    .ifPresent(
                            value ->
                                    found.add(
                                            of(value, "the value of '" + attribute.name() + "'")));
        } else {
            String kind = member instanceof Method ? "method" : "attribute";
            found.add(of(member, kind + " '" + member.name() + "'"));
        }
    }
}

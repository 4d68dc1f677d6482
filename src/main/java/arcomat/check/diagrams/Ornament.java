package arcomat.check.diagrams;

import arcomat.check.facts.Deletion;
import arcomat.source.Fix;
import arcomat.source.Fix.TextEdit;
import arcomat.source.Span;
import arcomat.tree.ClassDiagram;
import arcomat.tree.ClassDiagram.Attribute;
import arcomat.tree.ClassDiagram.ClassDefinition;
import arcomat.tree.ClassDiagram.EnumDefinition;
import arcomat.tree.ClassDiagram.Member;
import arcomat.tree.ClassDiagram.Method;
import arcomat.tree.Name;
import arcomat.tree.Node;
import arcomat.tree.TypeReference;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Stream;

/**
 * Something in the definition of a type that means nothing here.
 *
 * @param words how messages call it
 * @param repair takes it away
 */
record Ornament(Span place, String words, Fix repair) {

    /** In the order of the text. */
    static List<Ornament> of(ClassDiagram.TypeDefinition type) {
        List<Ornament> found = new ArrayList<>();
        type.modifiers().forEach(each -> found.add(modifier(each)));
        if (!type.interfaces().isEmpty()) {
            found.add(interfaces(type));
        }
        boolean hasAttributes = type instanceof ClassDefinition;
        type.members().forEach(each -> member(each, hasAttributes, found));
        if (type instanceof EnumDefinition definition) {
            definition
                    .arguments()
                    .forEach(each -> found.add(cut(each.span(), "values of '" + each.constant() + "'")));
        }
        found.sort(Comparator.comparingInt(each -> each.place().start()));
        return found;
    }

    Stream<TextEdit> deletion() {
        return repair.edits().stream();
    }

    private static void member(Member member, boolean hasAttributes, List<Ornament> found) {
        if (member instanceof Attribute attribute && hasAttributes) {
            attribute.modifiers().forEach(each -> found.add(modifier(each)));
            if (attribute.value().isPresent()) {
                found.add(value(attribute));
            }
        } else {
            String kind = member instanceof Method ? "method" : "attribute";
            found.add(line(member, kind + " '" + member.name() + "'"));
        }
    }

    /** With the space behind it. */
    private static Ornament modifier(Name modifier) {
        Span span = modifier.span();
        String text = span.file().text();
        int end = span.end();
        while (Character.isWhitespace(text.charAt(end))) {
            end++;
        }
        Span cut = span.file().span(span.start(), end);
        return new Ornament(span, "'" + modifier + "'", Fix.replace("", cut, ""));
    }

    private static Ornament interfaces(ClassDiagram.TypeDefinition type) {
        Span before =
                type instanceof ClassDefinition definition && definition.superClass().isPresent()
                        ? definition.superClass().get().span()
                        : type.name().span();
        List<TypeReference> all = type.interfaces();
        Span clause = before.file().span(before.end(), all.get(all.size() - 1).span().end());
        return new Ornament(
                all.get(0).span(), "interface '" + all.get(0).span().text() + "'", Fix.replace("", clause, ""));
    }

    /** All between the name and the semicolon. */
    private static Ornament value(Attribute attribute) {
        Span name = attribute.name().span();
        Span rest = name.file().span(name.end(), attribute.span().end() - 1);
        return new Ornament(
                attribute.value().orElseThrow().span(),
                "the value of '" + attribute.name() + "'",
                Fix.replace("", rest, ""));
    }

    private static Ornament cut(Span place, String words) {
        return new Ornament(place, words, Fix.replace("", place, ""));
    }

    private static Ornament line(Node node, String words) {
        return new Ornament(node.span(), words, Deletion.ofLine("", node));
    }
}

package arcomat.editor.answer.completion;

import arcomat.editor.answer.completion.Proposal.Kind;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.signatures.Signature;
import arcomat.tree.Component;
import arcomat.tree.Element;
import arcomat.tree.Name;
import arcomat.tree.QualifiedName;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.Stream;

/**
 * The features that a condition may speak of, and those that arguments may choose.
 *
 * @param place what is around the place
 */
record KnownFeatures(WritingPlace place) {

    /**
     * @param rules of the grammar around the name, innermost first
     */
    boolean areMeant(List<String> rules) {
        List<String> inside = rules.stream().takeWhile(rule -> !rule.equals("element")).toList();
        return isCondition(inside)
                || inside.contains("componentArguments")
                        && !featuresOf(named()).isEmpty()
                        && inside.contains("primary");
    }

    private static boolean isCondition(List<String> inside) {
        return inside.contains("variation") || inside.contains("constraint");
    }

    /** Behind an equals sign, those of the component around; else what arguments may name. */
    List<Proposal> proposals() {
        List<Proposal> proposals = new ArrayList<>();
        List<String> words = place.caret().statement();
        boolean isChosen =
                words.lastIndexOf("=") > Math.max(words.lastIndexOf(","), words.indexOf("("));
        Optional<Signature> named = words.contains("component") ? named() : Optional.empty();
        if (named.isPresent() && !isChosen) {
            featuresOf(named).forEach(name -> proposals.add(feature(name)));
            named.get().parameters().forEach(each -> proposals.add(Proposal.of(each)));
        } else {
            featuresOf(around()).forEach(name -> proposals.add(feature(name)));
            Stream.of("true", "false")
                    .forEach(truth -> proposals.add(Proposal.of(truth, Kind.TRUTH, "Boolean")));
        }
        return proposals;
    }

    private static Proposal feature(String name) {
        return Proposal.of(name, Kind.FEATURE, "feature");
    }

    private static List<String> featuresOf(Optional<Signature> component) {
        return component.stream()
                .map(Signature::node)
                .flatMap(node -> features(node))
                .distinct()
                .toList();
    }

    private static Stream<String> features(Component node) {
        return node.elements(Element.Features.class).stream()
                .flatMap(each -> each.names().stream())
                .map(Name::text);
    }

    /** The component that the file is about. */
    private Optional<Signature> around() {
        Optional<Signature> here = place.component().map(ComponentSymbol::signature);
        while (here.flatMap(Signature::enclosing).isPresent()) {
            here = here.flatMap(Signature::enclosing);
        }
        return here;
    }

    /** The component in front of the parenthesis: {@code component Lamp(}. */
    private Optional<Signature> named() {
        List<String> words = place.caret().statement();
        int from = words.indexOf("component") + 1;
        int end = words.indexOf("(");
        if (from < 1 || end <= from) {
            return Optional.empty();
        }
        List<Name> names =
                words.subList(from, end).stream()
                        .filter(word -> !word.equals("."))
                        .map(word -> new Name(place.caret().written(), word))
                        .toList();
        return place.component()
                .flatMap(
                        whole ->
                                whole.signature()
                                        .resolveComponent(
                                                new QualifiedName(place.caret().written(), names))
                                        .found());
    }
}

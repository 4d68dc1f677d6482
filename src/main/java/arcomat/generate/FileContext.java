package arcomat.generate;

import arcomat.generate.language.Names;
import arcomat.generate.language.References;
import arcomat.generate.language.Scope;
import arcomat.generate.language.TypeName;
import arcomat.model.Component;
import arcomat.model.Type;
import arcomat.semantics.network.Composition;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** What is needed to write the file of one component: its names and how it names others. */
record FileContext(
        Component component,
        Optional<Composition> composition,
        Names names,
        TypeName self,
        References references,
        Members members,
        ExpressionText expressions) {

    /**
     * @param reserved entries of the target with words that no member may be called
     */
    static FileContext of(
            Component component,
            Optional<Composition> composition,
            Names names,
            List<String> reserved) {
        TypeName self = names.of(component);
        References references = new References(names.language(), self);
        for (Type type : MentionedTypes.of(component, composition)) {
            references.to(names.of(type));
        }
        composition.ifPresent(
                c -> c.nodes().forEach(node -> references.to(names.of(node.component()))));
        Members members = new Members(component, composition, visible(names, references, reserved));
        return new FileContext(
                component,
                composition,
                names,
                self,
                references,
                members,
                new ExpressionText(names, references, members));
    }

    /** No member may be called as a type that the file mentions, or as a reserved word. */
    private static Members.Names visible(
            Names names, References references, List<String> reserved) {
        Scope scope = Scope.of(names.language().reserved());
        for (String entry : reserved) {
            Arrays.asList(names.language().words(entry)).forEach(scope::claim);
        }
        for (String name : references.briefNames()) {
            scope.claim(name);
            for (String suffix : names.language().words("companions")) {
                scope.claim(name + suffix);
            }
        }
        return new Members.Names(names.language(), scope);
    }
}

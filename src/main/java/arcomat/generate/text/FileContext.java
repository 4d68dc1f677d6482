package arcomat.generate.text;

import arcomat.generate.language.FileReferences;
import arcomat.generate.language.TargetLanguage;
import arcomat.generate.language.TargetNames;
import arcomat.generate.language.TypeName;
import arcomat.generate.language.UniqueNames;
import arcomat.model.Component;
import arcomat.model.Type;
import arcomat.semantics.network.Composition;

import java.util.Optional;

/** What is needed to write the file of one component: its names and how it names others. */
public record FileContext(
        Component component,
        Optional<Composition> composition,
        TargetNames names,
        TypeName self,
        FileReferences references,
        MemberNames members,
        ExpressionWriter expressions) {

    /**
     * @param reserved entries of the target with words that no member may be called
     */
    public static FileContext of(
            Component component,
            Optional<Composition> composition,
            TargetNames names,
            String... reserved) {
        TypeName self = names.of(component);
        FileReferences references = new FileReferences(names.language(), self);
        for (Type type : MentionedTypes.of(component, composition)) {
            if (!names.language().namesJava(type)) {
                references.to(names.of(type));
            }
        }
        composition.ifPresent(
                c -> c.nodes().forEach(node -> references.to(names.of(node.component()))));
        MemberNames members =
                new MemberNames(
                        component,
                        composition,
                        names.language(),
                        unhidden(names.language(), references, reserved));
        return new FileContext(
                component,
                composition,
                names,
                self,
                references,
                members,
                new ExpressionWriter(names, references, members));
    }

    /** No member may be called as a type that the file mentions, or as a reserved word. */
    private static UniqueNames unhidden(
            TargetLanguage language, FileReferences references, String... reserved) {
        UniqueNames free = language.unreserved(reserved);
        for (String name : references.briefNames()) {
            free.claim(name);
            for (String suffix : language.words("companions")) {
                free.claim(name + suffix);
            }
        }
        return free;
    }

    /** Whether the component is driven by events; else it works slice by slice. */
    public boolean isEventDriven() {
        return component.profile() == Component.Profile.EVENT_DRIVEN;
    }
}

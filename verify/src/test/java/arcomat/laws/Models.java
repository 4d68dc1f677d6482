package arcomat.laws;

import arcomat.check.Checks;
import arcomat.check.law.Profile;
import arcomat.laws.draw.Ranks;
import arcomat.lower.Lowering;
import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.models.ReadModels;
import arcomat.source.Diagnostic;
import arcomat.source.Severity;
import arcomat.source.SourceFile;
import arcomat.symbols.Workspace;

import java.util.List;
import java.util.Optional;

/**
 * Models that have gone the whole way from their text.
 *
 * @param seed for what is drawn while a law is looked at
 */
record Models(List<SourceFile> files, Model model, int seed) {

    /** Empty where the text breaks a context condition, or says nothing about a component. */
    static Optional<Models> read(List<SourceFile> files, int seed) {
        Workspace workspace = ReadModels.workspace(files);
        for (Diagnostic finding : Checks.run(workspace, Profile.REQUIREMENTS)) {
            if (finding.severity() == Severity.ERROR) {
                return Optional.empty();
            }
        }
        Model model = Ranks.of(Lowering.lower(workspace));
        boolean silent =
                model.components().stream()
                        .anyMatch(c -> !c.isComposite() && c.automata().isEmpty());
        return silent ? Optional.empty() : Optional.of(new Models(files, model, seed));
    }

    Component component(String name) {
        return model.component(name).orElseThrow();
    }
}

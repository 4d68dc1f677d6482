package arcomat.analysis.refinement;

import arcomat.analysis.search.Budget;
import arcomat.model.Model;
import arcomat.models.ReadModels;
import arcomat.semantics.Promise;
import arcomat.source.SourceFile;

import java.util.List;

/** What is compared: the components {@code Left} and {@code Right} of two texts. */
public record Sides(Promise left, Promise right) {
    public static Sides of(List<String> texts) {
        Model model =
                ReadModels.model(
                        new SourceFile("Left.arc", texts.get(0)),
                        new SourceFile("Right.arc", texts.get(1)));
        return new Sides(promise(model, "Left"), promise(model, "Right"));
    }

    private static Promise promise(Model model, String name) {
        return Promise.of(model.component(name).orElseThrow(), List.of());
    }

    public Verdict check(Budget budget) {
        return Refinement.check(left, right, budget);
    }
}

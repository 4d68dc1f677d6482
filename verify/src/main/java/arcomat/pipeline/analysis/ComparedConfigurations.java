package arcomat.pipeline.analysis;

import arcomat.pipeline.check.ChosenComponent;
import arcomat.pipeline.check.LoweredModels;
import arcomat.pipeline.check.PromiseReference;
import arcomat.symbols.Workspace;

import java.util.ArrayList;
import java.util.List;

/**
 * What two sides mean where a component has features that nobody chooses: each configuration of the
 * left side is to refine each one of the right side in which features of one name are chosen alike.
 *
 * @param pairs with all features chosen
 * @param alone configurations of the left side with which none of the right side agrees
 */
record ComparedConfigurations(List<ComparedSides> pairs, List<String> alone) {
    ComparedConfigurations {
        pairs = List.copyOf(pairs);
        alone = List.copyOf(alone);
    }

    static ComparedConfigurations of(ComparedSides sides, LoweredModels models) {
        Workspace workspace = models.checked().workspace();
        PromiseReference left = PromiseReference.parse(sides.left());
        PromiseReference right = PromiseReference.parse(sides.right());
        List<ChosenComponent> promises = ChosenComponent.of(right.component(), workspace);
        List<ComparedSides> pairs = new ArrayList<>();
        List<String> alone = new ArrayList<>();
        for (ChosenComponent each : ChosenComponent.of(left.component(), workspace)) {
            List<ChosenComponent> agreeing = promises.stream().filter(each::agrees).toList();
            for (ChosenComponent other : agreeing) {
                pairs.add(sides.of(written(each, left), written(other, right)));
            }
            if (agreeing.isEmpty()) {
                alone.add(each.written());
            }
        }
        return new ComparedConfigurations(pairs, alone);
    }

    private static String written(ChosenComponent component, PromiseReference as) {
        return component.written() + as.automaton().map(name -> "#" + name).orElse("");
    }
}

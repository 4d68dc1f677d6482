package arcomat.pipeline.check;

import arcomat.model.Component;
import arcomat.model.Model;
import arcomat.source.Span;

import java.util.List;

/**
 * Models without errors, and what they mean.
 *
 * @param checked as they are written
 * @param model what all of them mean, those that the user did not name included
 */
public record LoweredModels(CheckedModels checked, Model model) {
    /** Whether a place is in a file that the user named. */
    public boolean isNamed(Span place) {
        return checked.loaded().isNamedByUser(place.file().path());
    }

    /** The components that are not those of libraries, whose code somebody else makes. */
    public List<Component> own() {
        return model.components().stream()
                .filter(each -> !checked.loaded().isOfLibrary(each.span().file().path()))
                .toList();
    }

    /** The components in files that the user named. */
    public List<Component> named() {
        return model.components().stream().filter(each -> isNamed(each.span())).toList();
    }
}

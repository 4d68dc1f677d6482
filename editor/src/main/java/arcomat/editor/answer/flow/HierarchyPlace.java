package arcomat.editor.answer.flow;

import arcomat.pipeline.recheck.OpenModels;
import arcomat.symbols.bodies.ComponentSymbol;
import arcomat.symbols.occurrences.Referent;

import com.google.gson.Gson;
import com.google.gson.JsonElement;
import com.google.gson.JsonParseException;

import java.util.Optional;
import java.util.stream.Stream;

/**
 * Where an item of a hierarchy is found again, when an editor asks for those next to it.
 *
 * @param address of the file from which the hierarchy was asked for: it tells the models
 * @param path of the file in which the item is declared, among those models
 * @param start the offset of its name, or of its type where it has its name from that
 * @param kind of the item
 * @param name of the item: elements of an array are declared in one place
 */
public record HierarchyPlace(
        String address, String path, int start, Referent.Kind kind, String name) {

    static HierarchyPlace of(Referent referent, String address) {
        var place = referent.declaration().orElseThrow();
        return new HierarchyPlace(
                address, place.file().path(), place.start(), referent.kind(), referent.name());
    }

    JsonElement written() {
        return new Gson().toJsonTree(this);
    }

    /** Empty for what was not written here. */
    public static Optional<HierarchyPlace> read(Object data) {
        try {
            return data instanceof JsonElement json
                    ? Optional.ofNullable(new Gson().fromJson(json, HierarchyPlace.class))
                            .filter(place -> place.address != null)
                    : Optional.empty();
        } catch (JsonParseException foreign) {
            return Optional.empty();
        }
    }

    /** What is there now; nothing where the text has changed in between. */
    Optional<Referent> find(OpenModels models) {
        return models.workspace().components().stream()
                .filter(each -> each.unit().file().path().equals(path))
                .flatMap(HierarchyPlace::items)
                .filter(each -> each.kind() == kind && each.name().equals(name))
                .filter(each -> each.declaration().orElseThrow().start() == start)
                .findFirst();
    }

    private static Stream<Referent> items(ComponentSymbol component) {
        return Stream.of(
                        Stream.of(new Referent.Component(component.signature())),
                        component.ownInstances().stream().map(Referent.Part::new),
                        component.signature().ownPorts().stream().map(Referent.Port::new))
                .flatMap(each -> each);
    }
}

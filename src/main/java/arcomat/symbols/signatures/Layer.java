package arcomat.symbols.signatures;

import java.util.Optional;

/** The three layers of a robot program. */
public enum Layer {
    SENSORS,
    LOGIC,
    ACTUATORS;

    /** The name as it stands in the stereotype. */
    public String text() {
        return name().toLowerCase(java.util.Locale.ROOT);
    }

    public static Optional<Layer> named(String text) {
        for (Layer layer : values()) {
            if (layer.text().equals(text)) {
                return Optional.of(layer);
            }
        }
        return Optional.empty();
    }
}

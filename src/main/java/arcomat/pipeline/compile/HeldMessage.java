package arcomat.pipeline.compile;

import arcomat.generate.CodeLayout;
import arcomat.model.Port;
import arcomat.model.Type;
import arcomat.model.Value;

import java.util.Objects;
import java.util.Optional;

/**
 * The fields in which compiled code holds what a port shows.
 *
 * @param presence whether there is a message; empty where the message says it itself
 */
record HeldMessage(Port port, Slot message, Optional<Slot> presence, ModelValues values) {
    static HeldMessage of(Port port, Object owner, CodeLayout.Place place, ModelValues values) {
        return new HeldMessage(
                port,
                new Slot(owner, Objects.requireNonNull(place.messages().get(port.name()))),
                Optional.ofNullable(place.presences().get(port.name()))
                        .map(field -> new Slot(owner, field)),
                values);
    }

    Optional<Value> read() {
        Object held = message.get();
        boolean absent =
                presence.isPresent()
                        ? presence.get().get().equals(false)
                        : port.type() instanceof Type.EnumType && held.equals(0);
        return absent ? Optional.empty() : Optional.of(values.of(held, port.type()));
    }
}

package arcomat.live.robot;

import arcomat.model.Value;

import java.util.Optional;
import java.util.function.Function;

/** {@code nxt.BluetoothOut}. */
record Sending(Routine routine, Telephones telephones, String peer, int channel) implements Part {
    @Override
    public void begin() {
        telephones.begin(peer);
        routine.call(() -> telephones.to(peer).outgoing(channel));
    }

    @Override
    public void act(Function<String, Optional<Value>> in) {
        in.apply("sent")
                .ifPresent(
                        message ->
                                routine.call(
                                        () ->
                                                telephones
                                                        .to(peer)
                                                        .outgoing(channel)
                                                        .put(MessageCode.of(message))));
    }
}

package arcomat.live.robot;

import arcomat.model.Type;
import arcomat.model.Value;

import java.util.function.Consumer;

/**
 * {@code nxt.BluetoothIn}.
 *
 * @param type of its messages
 */
record Receiving(Routine routine, Telephones telephones, String peer, int channel, Type type)
        implements Part {
    @Override
    public void begin() {
        telephones.begin(peer);
        routine.call();
    }

    @Override
    public void sense(Consumer<Value> out) {
        Mailbox box = telephones.to(peer).incoming(channel);
        routine.call(
                () -> {
                    if (!box.isEmpty()) {
                        routine.call(() -> MessageCode.read(box.take(), type).ifPresent(out));
                    }
                });
    }
}

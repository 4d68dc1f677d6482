package nxt;

/**
 * Messages to another brick. Both bricks name the type of the messages: Integer, Boolean or the
 * same enum.
 *
 * A message takes some 30 ms. While the other brick is away, the last 8 messages wait.
 *
 * peer, channel: as for BluetoothIn
 */
<<platform,
        layer = "actuators">> component BluetoothOut<M>(String peer, Integer[0..7] channel = 0) {
    port in M sent;
}

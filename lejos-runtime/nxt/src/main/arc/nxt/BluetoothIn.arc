package nxt;

/**
 * Messages from another brick. Both bricks name the type of the messages: Integer, Boolean or the
 * same enum.
 *
 * One slice takes one message; up to 8 wait, and where more come the oldest are lost.
 *
 * peer: the name of the other brick if this one is to call it; empty if it is to be called. Of
 * two bricks, one calls. Before the first time they have to be paired. While the other one is
 * away, nothing arrives; it is called again and again.
 * channel: keeps several ports between the same two bricks apart; equal on both sides
 */
<<platform, layer = "sensors">> component BluetoothIn<M>(String peer, Integer[0..7] channel = 0) {
    port out M received;
}

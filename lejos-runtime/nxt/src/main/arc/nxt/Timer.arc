package nxt;

import nxt.Brick.Tick;

/**
 * Sends a tick at a fixed rate, by the clock of the brick. Late ticks do not add up: the next one
 * comes when it would have come anyway, and of those that fall into one slice one is sent.
 *
 * A timer that the logic starts is logic, because messages do not flow back from the logic to the
 * sensors: let it count slices, or ticks of this timer.
 *
 * period: from tick to tick, in ms; the first one comes one period after the start
 */
<<platform, layer = "sensors">> component Timer(Integer[1..86400000] period) {
    port out Tick signal;
}

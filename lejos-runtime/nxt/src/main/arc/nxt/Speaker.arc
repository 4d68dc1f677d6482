package nxt;

/**
 * The loudspeaker of the brick. A new tone ends the one that sounds.
 *
 * duration: of every tone, in ms
 * volume: of every tone, in percent
 */
<<platform, layer = "actuators">> component Speaker(Integer[1..60000] duration = 200,
        Integer[0..100] volume = 80) {
    /** Of a tone, in Hz. */
    port in Integer[31..14080] frequency;
}

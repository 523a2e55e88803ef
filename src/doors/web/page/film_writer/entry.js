// What pages take of Mediabunny (MPL-2.0): MP4 and WebM from packets.
import {BufferTarget, EncodedPacket, EncodedVideoPacketSource, Mp4OutputFormat, Output, StreamTarget, TextSubtitleSource, WebMOutputFormat} from 'mediabunny';
globalThis.film_writer = {BufferTarget, EncodedPacket, EncodedVideoPacketSource, Mp4OutputFormat, Output, StreamTarget, TextSubtitleSource, WebMOutputFormat};

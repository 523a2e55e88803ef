// FFmpeg's functions, found when first called. FFmpeg and what it is linked with are a hundred
// libraries, which take a fifth of the time of a still picture that has no use for them; so the
// program is linked with none, and the names that its headers declare are defined here. A signature
// that differs from the header's does not compile; one that is missing does not link. The tests use
// these, too.
extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/crc.h>
#include <libavutil/md5.h>
#include <libavutil/opt.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

#include <cstdint>

#include "system/shared_library.h"

namespace {

using poinsot::SharedLibrary;

// Each as the headers' version names it, of the Debian package that ends so.
#define POINSOT_LIBRARY(name, version)                                               \
    const SharedLibrary& name() {                                                    \
        static const SharedLibrary library("lib" #name ".so." AV_STRINGIFY(version), \
                                           "lib" #name AV_STRINGIFY(version));       \
        return library;                                                              \
    }
POINSOT_LIBRARY(avutil, LIBAVUTIL_VERSION_MAJOR)
POINSOT_LIBRARY(avcodec, LIBAVCODEC_VERSION_MAJOR)
POINSOT_LIBRARY(avformat, LIBAVFORMAT_VERSION_MAJOR)
POINSOT_LIBRARY(swscale, LIBSWSCALE_VERSION_MAJOR)

}  // namespace

#define POINSOT_CALL(library, result, name, parameters, arguments)              \
    result name parameters {                                                    \
        static const auto found = library().function<result parameters>(#name); \
        return found arguments;                                                 \
    }

extern "C" {

// libavutil: memory, frames, dictionaries, names of colours.
POINSOT_CALL(avutil, const char*, av_chroma_location_name, (AVChromaLocation location), (location))
POINSOT_CALL(avutil, const char*, av_color_primaries_name, (AVColorPrimaries primaries),
             (primaries))
POINSOT_CALL(avutil, const char*, av_color_range_name, (AVColorRange range), (range))
POINSOT_CALL(avutil, const char*, av_color_space_name, (AVColorSpace space), (space))
POINSOT_CALL(avutil, const char*, av_color_transfer_name, (AVColorTransferCharacteristic transfer),
             (transfer))
POINSOT_CALL(avutil, uint32_t, av_crc,
             (const AVCRC* ctx, uint32_t crc, const std::uint8_t* buffer, std::size_t length),
             (ctx, crc, buffer, length))
POINSOT_CALL(avutil, const AVCRC*, av_crc_get_table, (AVCRCId crc_id), (crc_id))
POINSOT_CALL(avutil, int, av_dict_count, (const AVDictionary* m), (m))
POINSOT_CALL(avutil, void, av_dict_free, (AVDictionary * *m), (m))
POINSOT_CALL(avutil, AVDictionaryEntry*, av_dict_get,
             (const AVDictionary* m, const char* key, const AVDictionaryEntry* prev, int flags),
             (m, key, prev, flags))
POINSOT_CALL(avutil, int, av_dict_set,
             (AVDictionary * *pm, const char* key, const char* value, int flags),
             (pm, key, value, flags))
POINSOT_CALL(avutil, AVFrame*, av_frame_alloc, (), ())
POINSOT_CALL(avutil, void, av_frame_free, (AVFrame * *frame), (frame))
POINSOT_CALL(avutil, int, av_frame_get_buffer, (AVFrame * frame, int align), (frame, align))
POINSOT_CALL(avutil, int, av_frame_make_writable, (AVFrame * frame), (frame))
POINSOT_CALL(avutil, void, av_free, (void* ptr), (ptr))
POINSOT_CALL(avutil, void, av_freep, (void* ptr), (ptr))
POINSOT_CALL(avutil, const char*, av_get_pix_fmt_name, (AVPixelFormat pix_fmt), (pix_fmt))
POINSOT_CALL(avutil, void, av_log_set_level, (int level), (level))
POINSOT_CALL(avutil, void*, av_malloc, (std::size_t size), (size))
POINSOT_CALL(avutil, void*, av_mallocz, (std::size_t size), (size))
POINSOT_CALL(avutil, void, av_md5_sum,
             (std::uint8_t * dst, const std::uint8_t* src, std::size_t len), (dst, src, len))
POINSOT_CALL(avutil, int, av_opt_set_int,
             (void* obj, const char* name, std::int64_t val, int search_flags),
             (obj, name, val, search_flags))
POINSOT_CALL(avutil, void*, av_realloc_array, (void* ptr, std::size_t nmemb, std::size_t size),
             (ptr, nmemb, size))
POINSOT_CALL(avutil, std::int64_t, av_rescale_q, (std::int64_t a, AVRational bq, AVRational cq),
             (a, bq, cq))
POINSOT_CALL(avutil, int, av_strerror, (int errnum, char* errbuf, std::size_t errbuf_size),
             (errnum, errbuf, errbuf_size))
POINSOT_CALL(avutil, const char*, av_version_info, (), ())

// libavcodec: encoders, decoders, packets.
POINSOT_CALL(avcodec, int, av_new_packet, (AVPacket * pkt, int size), (pkt, size))
POINSOT_CALL(avcodec, AVPacket*, av_packet_alloc, (), ())
POINSOT_CALL(avcodec, void, av_packet_free, (AVPacket * *pkt), (pkt))
POINSOT_CALL(avcodec, uint8_t*, av_packet_get_side_data,
             (const AVPacket* pkt, AVPacketSideDataType type, std::size_t* size), (pkt, type, size))
POINSOT_CALL(avcodec, int, av_packet_make_writable, (AVPacket * pkt), (pkt))
POINSOT_CALL(avcodec, uint8_t*, av_packet_new_side_data,
             (AVPacket * pkt, AVPacketSideDataType type, std::size_t size), (pkt, type, size))
POINSOT_CALL(avcodec, void, av_packet_rescale_ts,
             (AVPacket * pkt, AVRational tb_src, AVRational tb_dst), (pkt, tb_src, tb_dst))
POINSOT_CALL(avcodec, void, av_packet_unref, (AVPacket * pkt), (pkt))
POINSOT_CALL(avcodec, AVCodecContext*, avcodec_alloc_context3, (const AVCodec* codec), (codec))
POINSOT_CALL(avcodec, const AVCodec*, avcodec_find_decoder, (AVCodecID id), (id))
POINSOT_CALL(avcodec, const AVCodec*, avcodec_find_decoder_by_name, (const char* name), (name))
POINSOT_CALL(avcodec, const AVCodec*, avcodec_find_encoder_by_name, (const char* name), (name))
POINSOT_CALL(avcodec, void, avcodec_flush_buffers, (AVCodecContext * avctx), (avctx))
POINSOT_CALL(avcodec, void, avcodec_free_context, (AVCodecContext * *avctx), (avctx))
POINSOT_CALL(avcodec, const char*, avcodec_get_name, (AVCodecID id), (id))
POINSOT_CALL(avcodec, int, avcodec_open2,
             (AVCodecContext * avctx, const AVCodec* codec, AVDictionary** options),
             (avctx, codec, options))
POINSOT_CALL(avcodec, int, avcodec_parameters_from_context,
             (AVCodecParameters * par, const AVCodecContext* codec), (par, codec))
POINSOT_CALL(avcodec, int, avcodec_parameters_to_context,
             (AVCodecContext * codec, const AVCodecParameters* par), (codec, par))
POINSOT_CALL(avcodec, int, avcodec_receive_frame, (AVCodecContext * avctx, AVFrame* frame),
             (avctx, frame))
POINSOT_CALL(avcodec, int, avcodec_receive_packet, (AVCodecContext * avctx, AVPacket* avpkt),
             (avctx, avpkt))
POINSOT_CALL(avcodec, int, avcodec_send_frame, (AVCodecContext * avctx, const AVFrame* frame),
             (avctx, frame))
POINSOT_CALL(avcodec, int, avcodec_send_packet, (AVCodecContext * avctx, const AVPacket* avpkt),
             (avctx, avpkt))

// libavformat: containers.
POINSOT_CALL(avformat, int, av_find_best_stream,
             (AVFormatContext * ic, AVMediaType type, int wanted_stream_nb, int related_stream,
              const AVCodec** decoder_ret, int flags),
             (ic, type, wanted_stream_nb, related_stream, decoder_ret, flags))
POINSOT_CALL(avformat, AVRational, av_guess_frame_rate,
             (AVFormatContext * ctx, AVStream* stream, AVFrame* frame), (ctx, stream, frame))
POINSOT_CALL(avformat, int, av_interleaved_write_frame, (AVFormatContext * s, AVPacket* pkt),
             (s, pkt))
POINSOT_CALL(avformat, int, av_read_frame, (AVFormatContext * s, AVPacket* pkt), (s, pkt))
POINSOT_CALL(avformat, int, av_seek_frame,
             (AVFormatContext * s, int stream_index, std::int64_t timestamp, int flags),
             (s, stream_index, timestamp, flags))
POINSOT_CALL(avformat, int, av_write_trailer, (AVFormatContext * s), (s))
POINSOT_CALL(avformat, AVFormatContext*, avformat_alloc_context, (), ())
POINSOT_CALL(avformat, int, avformat_alloc_output_context2,
             (AVFormatContext * *ctx, const AVOutputFormat* oformat, const char* format_name,
              const char* filename),
             (ctx, oformat, format_name, filename))
POINSOT_CALL(avformat, void, avformat_close_input, (AVFormatContext * *s), (s))
POINSOT_CALL(avformat, int, avformat_find_stream_info,
             (AVFormatContext * ic, AVDictionary** options), (ic, options))
POINSOT_CALL(avformat, void, avformat_free_context, (AVFormatContext * s), (s))
POINSOT_CALL(avformat, AVStream*, avformat_new_stream, (AVFormatContext * s, const AVCodec* c),
             (s, c))
POINSOT_CALL(avformat, int, avformat_open_input,
             (AVFormatContext * *ps, const char* url, const AVInputFormat* fmt,
              AVDictionary** options),
             (ps, url, fmt, options))
POINSOT_CALL(avformat, int, avformat_write_header, (AVFormatContext * s, AVDictionary** options),
             (s, options))
POINSOT_CALL(avformat, AVIOContext*, avio_alloc_context,
             (unsigned char* buffer, int buffer_size, int write_flag, void* opaque,
              int (*read_packet)(void* opaque, std::uint8_t* buf, int buf_size),
              int (*write_packet)(void* opaque, std::uint8_t* buf, int buf_size),
              std::int64_t (*seek)(void* opaque, std::int64_t offset, int whence)),
             (buffer, buffer_size, write_flag, opaque, read_packet, write_packet, seek))
POINSOT_CALL(avformat, void, avio_context_free, (AVIOContext * *s), (s))
POINSOT_CALL(avformat, void, avio_flush, (AVIOContext * s), (s))

// libswscale: conversion.
POINSOT_CALL(swscale, SwsContext*, sws_alloc_context, (), ())
POINSOT_CALL(swscale, void, sws_freeContext, (SwsContext * swsContext), (swsContext))
POINSOT_CALL(swscale, const int*, sws_getCoefficients, (int colorspace), (colorspace))
POINSOT_CALL(swscale, SwsContext*, sws_getContext,
             (int srcW, int srcH, AVPixelFormat srcFormat, int dstW, int dstH,
              AVPixelFormat dstFormat, int flags, SwsFilter* srcFilter, SwsFilter* dstFilter,
              const double* param),
             (srcW, srcH, srcFormat, dstW, dstH, dstFormat, flags, srcFilter, dstFilter, param))
POINSOT_CALL(swscale, int, sws_init_context,
             (SwsContext * sws_context, SwsFilter* srcFilter, SwsFilter* dstFilter),
             (sws_context, srcFilter, dstFilter))
POINSOT_CALL(swscale, int, sws_scale,
             (SwsContext * c, const std::uint8_t* const srcSlice[], const int srcStride[],
              int srcSliceY, int srcSliceH, std::uint8_t* const dst[], const int dstStride[]),
             (c, srcSlice, srcStride, srcSliceY, srcSliceH, dst, dstStride))
POINSOT_CALL(swscale, int, sws_setColorspaceDetails,
             (SwsContext * c, const int inv_table[4], int srcRange, const int table[4],
              int dstRange, int brightness, int contrast, int saturation),
             (c, inv_table, srcRange, table, dstRange, brightness, contrast, saturation))

}  // extern "C"

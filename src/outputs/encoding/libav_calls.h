// Lazy loading of FFmpeg's functions, at their first call. FFmpeg and its dependencies are a
// hundred libraries, whose loading takes a fifth of the time of a still picture, which does not
// need them; therefore the program is linked with none of them. In namespace poinsot each name
// below hides FFmpeg's function and calls it with the type of FFmpeg's headers; a function that is
// missing here does not link. Included only inside output/.
#pragma once

extern "C" {
#include <libavcodec/avcodec.h>
#include <libavformat/avformat.h>
#include <libavutil/crc.h>
#include <libavutil/md5.h>
#include <libavutil/opt.h>
#include <libavutil/pixdesc.h>
#include <libswscale/swscale.h>
}

#include "system/shared_library.h"

namespace poinsot::libav {

// The file name of each library has the version number of its headers.
#define POINSOT_LIBRARY(name, version)                                               \
    inline const SharedLibrary& name() {                                             \
        static const SharedLibrary library("lib" #name ".so." AV_STRINGIFY(version), \
                                           "lib" #name AV_STRINGIFY(version));       \
        return library;                                                              \
    }
POINSOT_LIBRARY(avutil, LIBAVUTIL_VERSION_MAJOR)
POINSOT_LIBRARY(avcodec, LIBAVCODEC_VERSION_MAJOR)
POINSOT_LIBRARY(avformat, LIBAVFORMAT_VERSION_MAJOR)
POINSOT_LIBRARY(swscale, LIBSWSCALE_VERSION_MAJOR)
#undef POINSOT_LIBRARY

}  // namespace poinsot::libav

namespace poinsot {

#define POINSOT_CALL(library, name)                                                   \
    inline constexpr auto name = [](auto... arguments) {                              \
        static const auto found = libav::library().function<decltype(::name)>(#name); \
        return found(arguments...);                                                   \
    };

// libavutil: memory, frames, dictionaries, names of colours.
POINSOT_CALL(avutil, av_chroma_location_name)
POINSOT_CALL(avutil, av_color_primaries_name)
POINSOT_CALL(avutil, av_color_range_name)
POINSOT_CALL(avutil, av_color_space_name)
POINSOT_CALL(avutil, av_color_transfer_name)
POINSOT_CALL(avutil, av_crc)
POINSOT_CALL(avutil, av_crc_get_table)
POINSOT_CALL(avutil, av_dict_count)
POINSOT_CALL(avutil, av_dict_free)
POINSOT_CALL(avutil, av_dict_get)
POINSOT_CALL(avutil, av_dict_set)
POINSOT_CALL(avutil, av_frame_alloc)
POINSOT_CALL(avutil, av_frame_free)
POINSOT_CALL(avutil, av_frame_get_buffer)
POINSOT_CALL(avutil, av_frame_make_writable)
POINSOT_CALL(avutil, av_free)
POINSOT_CALL(avutil, av_freep)
POINSOT_CALL(avutil, av_get_pix_fmt_name)
POINSOT_CALL(avutil, av_log_set_level)
POINSOT_CALL(avutil, av_malloc)
POINSOT_CALL(avutil, av_mallocz)
POINSOT_CALL(avutil, av_max_alloc)
POINSOT_CALL(avutil, av_md5_sum)
POINSOT_CALL(avutil, av_opt_set_int)
POINSOT_CALL(avutil, av_realloc_array)
POINSOT_CALL(avutil, av_rescale_q)
POINSOT_CALL(avutil, av_strerror)
POINSOT_CALL(avutil, av_version_info)

// libavcodec: encoders, decoders, packets.
POINSOT_CALL(avcodec, av_new_packet)
POINSOT_CALL(avcodec, av_packet_alloc)
POINSOT_CALL(avcodec, av_packet_free)
POINSOT_CALL(avcodec, av_packet_get_side_data)
POINSOT_CALL(avcodec, av_packet_make_writable)
POINSOT_CALL(avcodec, av_packet_new_side_data)
POINSOT_CALL(avcodec, av_packet_rescale_ts)
POINSOT_CALL(avcodec, av_packet_unref)
POINSOT_CALL(avcodec, avcodec_alloc_context3)
POINSOT_CALL(avcodec, avcodec_find_decoder)
POINSOT_CALL(avcodec, avcodec_find_decoder_by_name)
POINSOT_CALL(avcodec, avcodec_find_encoder_by_name)
POINSOT_CALL(avcodec, avcodec_flush_buffers)
POINSOT_CALL(avcodec, avcodec_free_context)
POINSOT_CALL(avcodec, avcodec_get_name)
POINSOT_CALL(avcodec, avcodec_open2)
POINSOT_CALL(avcodec, avcodec_parameters_from_context)
POINSOT_CALL(avcodec, avcodec_parameters_to_context)
POINSOT_CALL(avcodec, avcodec_receive_frame)
POINSOT_CALL(avcodec, avcodec_receive_packet)
POINSOT_CALL(avcodec, avcodec_send_frame)
POINSOT_CALL(avcodec, avcodec_send_packet)

// libavformat: containers.
POINSOT_CALL(avformat, av_find_best_stream)
POINSOT_CALL(avformat, av_guess_frame_rate)
POINSOT_CALL(avformat, av_guess_sample_aspect_ratio)
POINSOT_CALL(avformat, av_interleaved_write_frame)
POINSOT_CALL(avformat, av_read_frame)
POINSOT_CALL(avformat, av_seek_frame)
POINSOT_CALL(avformat, av_write_trailer)
POINSOT_CALL(avformat, avformat_alloc_context)
POINSOT_CALL(avformat, avformat_alloc_output_context2)
POINSOT_CALL(avformat, avformat_close_input)
POINSOT_CALL(avformat, avformat_find_stream_info)
POINSOT_CALL(avformat, avformat_free_context)
POINSOT_CALL(avformat, avformat_new_stream)
POINSOT_CALL(avformat, avformat_open_input)
POINSOT_CALL(avformat, avformat_write_header)
POINSOT_CALL(avformat, avio_alloc_context)
POINSOT_CALL(avformat, avio_context_free)
POINSOT_CALL(avformat, avio_flush)

// libswscale: conversion.
POINSOT_CALL(swscale, sws_alloc_context)
POINSOT_CALL(swscale, sws_freeContext)
POINSOT_CALL(swscale, sws_getCoefficients)
POINSOT_CALL(swscale, sws_getContext)
POINSOT_CALL(swscale, sws_init_context)
POINSOT_CALL(swscale, sws_scale)
POINSOT_CALL(swscale, sws_setColorspaceDetails)
#undef POINSOT_CALL

}  // namespace poinsot
